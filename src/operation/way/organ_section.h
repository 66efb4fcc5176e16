// The section of an organ with a vertical plane x = const: where the organ begins and ends from
// back to front (along z), and the height of its top (y).
#pragma once

#include <vector>

#include "geometry/triangle_mesh.h"

namespace resect {

class OrganSection {
 public:
  // The section of a closed surface with the plane x = const, m. Cost: a pass over the triangles.
  OrganSection(const TriangleMesh& surface, double x);

  bool empty() const { return lines_.empty(); }
  // Along z, the organ may have gaps in this section. back() and front() are the ends, z, m, of its
  // longest stretch without a gap; back() is the end with the lower z.
  double back() const { return back_; }
  double front() const { return front_; }

  double lowest() const { return lowest_; }  // y of its lowest point, m
  // Greatest height from underside to top at one z, m. Hollows between underside and top are
  // included.
  double tallest() const { return tallest_; }
  // Height y of the top at this z, m. If the organ does not reach this z, the height of the top at
  // the nearest z that the organ reaches. Throws Error if empty().
  double topAt(double z) const;

 private:
  struct Line {  // section of the plane with a triangle, m
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
