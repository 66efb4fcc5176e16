// Places a region: converts fractions, landmarks and depths of an organ at rest to what
// Region::holds() uses.
#pragma once

#include <memory>
#include <optional>

#include "sph/discretization.h"
#include "sph/region.h"

namespace resect {

// The box round the cells of all particles, which fractions refer to: the box of the organ's
// surface, to half a cell. Empty without particles. Cost: a pass over the cells.
Aabb particleBox(const Discretization& cells);

// Box and surface are made for the first region that needs them, and shared. The surface is the
// cells' iso surface at 50; depths are good to a quarter of a cell (collision/signed_distance.h).
// Cost of the surface: that of building an organ.
class RegionPlacer {
 public:
  // Keeps a reference.
  explicit RegionPlacer(const Discretization& cells) : cells_(cells) {}

  // Throws Error when the region names a landmark that the cells do not have, or a depth in an
  // organ without a surface.
  Region operator()(Region region);

 private:
  const Discretization& cells_;
  std::optional<Aabb> box_;
  std::shared_ptr<const SignedDistance> skin_;
};

}  // namespace resect
