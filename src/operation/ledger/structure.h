// The shape of a labelled structure, such as a tumour, and its distance from points. The margin
// of a structure, its least distance from a wound, is computed from these distances.
//
// The shape is a smooth surface through the lattice. Each cell has a flag: 1 if it has the label,
// otherwise 0. The flags are averaged over each cell and its neighbours (weights 1, 2, 1 along each
// axis), and the surface lies where the average is one half. The centre of a cell with the label
// always lies inside the surface. The centre of any other cell lies outside. Distances along an
// axis of the lattice are accurate to half a cell, since the flags do not tell how far a structure
// extends beyond its last cells. Distances in other directions are accurate to a quarter of a cell.
#pragma once

#include <cstdint>
#include <vector>

#include "base/index_box.h"
#include "sph/discretization.h"

namespace resect {

class Structure {
 public:
  // label: number of a label that at least one particle of `rest` has.
  Structure(const Discretization& rest, int label);

  int label() const { return label_; }
  // The distance of a point from the structure, m, in rest space; or `best`, if `best` is smaller.
  // The distance is 0 inside the structure. The cost is small if the distance is larger than
  // `best`.
  double distance(const Vec3& point, double best) const;
  // Distance of a point from the box round the structure, m: a lower bound of the distance from the
  // structure. Cheap.
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
  IndexBox box_;  // all cells whose averaged flag can be above 0, and a halo of one cell
  // Per cell of the box: averaged flag, in 64ths. The cell's centre is inside if this is at
  // least 33.
  std::vector<std::uint8_t> share_;
  std::vector<Vec3f> points_;       // points of its surface, m, sorted as a k-d tree (sortInto())
  std::vector<std::uint8_t> axis_;  // per point: axis that divides the points below it in the tree
  Vec3f low_, high_;                // box round the points
};

}  // namespace resect
