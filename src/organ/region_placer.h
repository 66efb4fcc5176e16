// Where is a region of an organ that lies at rest as its cells do? Turns fractions, landmarks and
// depths into what Region::holds() can answer.
#pragma once

#include <memory>
#include <optional>

#include "sph/discretization.h"
#include "sph/region.h"

namespace resect {

// The box round the cells of all particles, which fractions refer to: that of the organ's surface
// to half a cell. Empty without particles. A pass over the cells.
Aabb particleBox(const Discretization& cells);

// Box and surface are made when the first region asks for them; regions share them. The surface is
// the one that cells draw at iso level 50; depths are good to a quarter of a cell
// (collision/signed_distance.h). Cost of the surface: that of building an organ.
class RegionPlacer {
 public:
  // Keeps a reference.
  explicit RegionPlacer(const Discretization& cells) : cells_(cells) {}

  // Throws Error when the region names a landmark that the cells do not have, or asks for depths in
  // an organ that has no surface.
  Region operator()(Region region);

 private:
  const Discretization& cells_;
  std::optional<Aabb> box_;
  std::shared_ptr<const SignedDistance> skin_;
};

}  // namespace resect
