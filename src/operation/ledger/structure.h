// The shape of a labelled structure, such as a tumour, and its distance from points: the margin.
//
// The shape is a smooth surface through the lattice: the label's flags are averaged over each cell
// and its neighbours (weights 1, 2, 1 along each axis), and the surface lies where the average is
// one half. Labelled cells always lie inside it, other cells outside. So a distance is good to a
// quarter of a cell, but only to half a cell along an axis of the lattice, where the flags do not
// tell how far a structure reaches beyond its last cells.
#pragma once

#include <cstdint>
#include <vector>

#include "base/index_box.h"
#include "sph/discretization.h"

namespace resect {

class Structure {
 public:
  // label: that some particle of `rest` has.
  Structure(const Discretization& rest, int label);

  int label() const { return label_; }
  // The smaller of `best` and the distance of a point from the structure, m, at rest; 0 within it.
  // The cost is small if the distance is larger than `best`.
  double distance(const Vec3& point, double best) const;
  // Distance of a point from the box round the structure, m: no more than distance(). Cheap.
  double boxDistance(const Vec3& point) const {
    const Vec3f p = point.cast<float>();
    return double((p - p.cwiseMax(low_).cwiseMin(high_)).norm());
  }

 private:
  bool holds(const Vec3& point) const;
  void addPoints(const Lattice& lattice);
  void sortInto(std::size_t begin, std::size_t end);
  void search(std::size_t begin, std::size_t end, const Vec3f& point, float& best) const;

  int label_ = 0;
  Vec3 origin_, spacing_;
  IndexBox box_;                     // of the cells that can have a share, and one cell round them
  std::vector<std::uint8_t> share_;  // per cell of the box, in 64ths; 33 and more: labelled
  std::vector<Vec3f> points_;        // of its surface, m, in the order of a tree of halves
  std::vector<std::uint8_t> axis_;   // per point: along which axis its range is halved there
  Vec3f low_, high_;                 // box round the points
};

}  // namespace resect
