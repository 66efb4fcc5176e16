// The outline of an organ in an upright plane across it: where it begins and ends from back to
// front, and how high its top is.
#pragma once

#include <vector>

#include "geometry/triangle_mesh.h"

namespace resect {

class OrganSection {
 public:
  // The section of a closed surface with the plane x = const, m. Cost: a pass over the triangles.
  OrganSection(const TriangleMesh& surface, double x);

  bool empty() const { return lines_.empty(); }
  // The longest stretch, from back (lower z) to front, over which the organ extends without a gap.
  double back() const { return back_; }
  double front() const { return front_; }

  double lowest() const { return lowest_; }  // y of its lowest point, m
  // Greatest height from underside to top at one place, m; what is hollow between counts as organ.
  double tallest() const { return tallest_; }
  // Height y of the top at this z, m; where the section is empty, of the nearest place where it is
  // not. Must not be called if empty().
  double topAt(double z) const;

 private:
  struct Line {  // where the plane meets a triangle
    double z[2], y[2];
  };
  struct Heights {
    double top, bottom;
  };
  Heights heightsAt(double z) const;
  std::vector<Line> lines_;
  double back_ = 0, front_ = 0, lowest_ = 0, tallest_ = 0;
};

}  // namespace resect
