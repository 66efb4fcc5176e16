// Queries about points of elastic tissue that are given in rest space: where such a point is at
// present, and what tissue lies round it.
#pragma once

#include <vector>

#include "sph/lattice.h"
#include "tissue/elastic/contact/points.h"
#include "tissue/elastic/elastic_state.h"

namespace resect {

// The cells that stand for a point of the tissue. A force on the point is spread over these cells,
// and their weighted mean motion is taken as the point's motion. Cells are given by their index in
// the CellBox.
struct PointCells {
  std::vector<std::int32_t> cells;
  std::vector<double> weights;  // one per cell; the weights add up to 1
  Vec3 mean = Vec3::Zero();     // weighted mean of the cells' rest positions, m
  std::int32_t nearest = -1;    // the cell whose centre is nearest at rest; -1: there is no cell
  // F - I of `nearest` at the time of findCells(). F is the deformation gradient.
  Mat3 gradient = Mat3::Zero();
};

// All points are given in rest space, m.
class RestTissue {
 public:
  // The arguments must outlive the object.
  RestTissue(const ElasticState& state, const Lattice& lattice, const ContactPoints& surface)
      : state_(state), lattice_(lattice), surface_(surface) {}

  // Finds the cells that stand for a point: the solid cells within the reach (kCutReach). The reach
  // is a fixed length, however small the cells are. If the reach shrank with the cells, a force on
  // one small cell could crush that cell. If no solid cell is within the reach, or if all that are
  // within it are almost a full reach away, the nearest solid cell stands for the point. If the
  // centre of that cell is more than two spacings (sides of a cell) away along any axis, no cell is
  // found.
  void findCells(const Vec3& point, PointCells& cells) const;
  Vec3 displacement(const Vec3& point, const PointCells& cells) const;  // m
  Vec3 velocity(const PointCells& cells) const;                         // m/s
  // The distance, m, between two estimates of the point's present position. One estimate uses the
  // mean over all cells of the point, the other uses its nearest cell alone. For a point between
  // the lips of an open cut, the result is half of the width of the gap.
  double apart(const Vec3& point, const PointCells& cells) const;
  // Whether the point lies in tissue: below the organ's surface, in a cell that was not removed.
  bool inside(const Vec3& point) const { return depth(point) > 0; }
  // Depth of the point below the organ's surface, m; negative outside. If the surface is a spacing
  // or more away, the result is kKnownDepth spacings in a solid cell and -kKnownDepth spacings
  // elsewhere.
  double depth(const Vec3& point) const;
  // Whether there is uncut tissue ahead of `point`. For this, a small rectangular strip is tested.
  // The strip's middle line leads from `point` to `point + ahead`. The strip is one spacing wide,
  // measured along the unit vector `along`. A pair of neighbouring solid cells crosses the strip if
  // the line between their centres does. The result is true in two cases: if the first pair that
  // crosses the strip, counted from `point`, is bonded, or if any pair that crosses the nearer half
  // of the strip is bonded.
  bool tissueAhead(const Vec3& point, const Vec3& along, const Vec3& ahead) const;

  const ElasticState& state() const { return state_; }
  const Lattice& lattice() const { return lattice_; }

  static constexpr double kCutReach = 0.009;  // reach, m; or 1.5 spacings, if longer
  static constexpr double kKnownDepth = 1;    // spacings

 private:
  std::int32_t nearestSolid(const Vec3& point) const;

  const ElasticState& state_;
  const Lattice& lattice_;
  const ContactPoints& surface_;
};

}  // namespace resect
