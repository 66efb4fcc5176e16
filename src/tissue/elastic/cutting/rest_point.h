// Points of elastic tissue at rest: where they are now, and what is round them.
#pragma once

#include <vector>

#include "sph/lattice.h"
#include "tissue/elastic/contact/points.h"
#include "tissue/elastic/elastic_state.h"

namespace resect {

// The cells that carry a force on a point of the tissue, and whose mean motion is that of the
// point. Cells are given by their index in the CellBox.
struct PointCells {
  std::vector<std::int32_t> cells;
  std::vector<double> weights;   // they add up to 1
  Vec3 mean = Vec3::Zero();      // weighted mean of the cells' rest positions, m
  std::int32_t nearest = -1;     // the cell whose centre is nearest at rest; -1: there is no cell
  Mat3 gradient = Mat3::Zero();  // F - I of that cell when the cells were found
};

// All points are given in rest space, m.
class RestTissue {
 public:
  // All must outlive the object.
  RestTissue(const ElasticState& state, const Lattice& lattice, const ContactPoints& surface)
      : state_(state), lattice_(lattice), surface_(surface) {}

  // Finds the cells round a point: the solid ones within kCutReach, or else the nearest one within
  // about two spacings. A point force would crush single cells, so it is spread over a length that
  // does not depend on the lattice.
  void findCells(const Vec3& point, PointCells& cells) const;
  Vec3 displacement(const Vec3& point, const PointCells& cells) const;  // m
  Vec3 velocity(const PointCells& cells) const;                         // m/s
  // How far the point is from where its nearest cell alone would have it, m. Between the lips of an
  // open cut this is half of the gap.
  double apart(const Vec3& point, const PointCells& cells) const;
  // Whether the point lies in tissue: below the organ's surface, in a cell that is left.
  bool inside(const Vec3& point) const { return depth(point) > 0; }
  // How deep below the surface the point lies, m: negative outside, and at least kKnownDepth
  // spacings where no surface is near.
  double depth(const Vec3& point) const;
  // Whether there is uncut tissue ahead: whether, of the pairs of neighbouring cells whose
  // connecting line crosses a small strip, the one nearest to `point` is bonded, or any one in the
  // nearer half. The strip's middle line leads from `point` along `ahead`; its width is a spacing
  // along the unit vector `along`.
  bool tissueAhead(const Vec3& point, const Vec3& along, const Vec3& ahead) const;

  const ElasticState& state() const { return state_; }
  const Lattice& lattice() const { return lattice_; }

  static constexpr double kCutReach = 0.009;  // m; on coarse lattices 1.5 spacings
  static constexpr double kKnownDepth = 1;

 private:
  std::int32_t nearestSolid(const Vec3& point) const;

  const ElasticState& state_;
  const Lattice& lattice_;
  const ContactPoints& surface_;
};

}  // namespace resect
