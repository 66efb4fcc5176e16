// Queries about points of elastic tissue at rest: their present positions, and the tissue round
// them.
#pragma once

#include <vector>

#include "sph/lattice.h"
#include "tissue/elastic/contact/points.h"
#include "tissue/elastic/elastic_state.h"

namespace resect {

// The cells over which a force on a point of the tissue is spread, and whose mean motion is taken
// as that of the point. Cells are given by their index in the CellBox.
struct PointCells {
  std::vector<std::int32_t> cells;
  std::vector<double> weights;   // they add up to 1
  Vec3 mean = Vec3::Zero();      // weighted mean of the cells' rest positions, m
  std::int32_t nearest = -1;     // the cell whose centre is nearest at rest; -1: there is no cell
  Mat3 gradient = Mat3::Zero();  // F - I of the nearest cell when the cells were found
};

// All points are given in rest space, m.
class RestTissue {
 public:
  // The arguments must outlive the object.
  RestTissue(const ElasticState& state, const Lattice& lattice, const ContactPoints& surface)
      : state_(state), lattice_(lattice), surface_(surface) {}

  // Finds the cells round a point: the solid cells within kCutReach, or if there are none the
  // nearest solid cell within about two spacings. A point force would crush single cells, so it is
  // spread over a length that does not depend on the lattice.
  void findCells(const Vec3& point, PointCells& cells) const;
  Vec3 displacement(const Vec3& point, const PointCells& cells) const;  // m
  Vec3 velocity(const PointCells& cells) const;                         // m/s
  // The distance, m, between two estimates of the point's present position: from the mean of all
  // its cells, and from its nearest cell alone. Between the lips of an open cut this is half of the
  // gap.
  double apart(const Vec3& point, const PointCells& cells) const;
  // Whether the point lies in tissue: below the organ's surface, in a cell that was not removed.
  bool inside(const Vec3& point) const { return depth(point) > 0; }
  // Depth of the point below the organ's surface, m; negative outside. Where the surface is a
  // spacing or more away: kKnownDepth spacings in a solid cell, -kKnownDepth spacings elsewhere.
  double depth(const Vec3& point) const;
  // Whether there is uncut tissue ahead. A small strip is laid whose middle line leads from `point`
  // to `point + ahead` and whose width is one spacing along the unit vector `along`. All pairs of
  // neighbouring solid cells are found whose connecting line crosses the strip. True if the pair
  // nearest to `point` is bonded, or any pair in the half of the strip that is nearer to `point`.
  bool tissueAhead(const Vec3& point, const Vec3& along, const Vec3& ahead) const;

  const ElasticState& state() const { return state_; }
  const Lattice& lattice() const { return lattice_; }

  static constexpr double kCutReach = 0.009;  // m; 1.5 spacings if that is more
  static constexpr double kKnownDepth = 1;    // spacings

 private:
  std::int32_t nearestSolid(const Vec3& point) const;

  const ElasticState& state_;
  const Lattice& lattice_;
  const ContactPoints& surface_;
};

}  // namespace resect
