// Places a region in an organ at rest, so that Region::holds() can be called. For this, fractions
// and landmarks are converted to positions in the world, and the surface from which depths are
// measured is added.
#pragma once

#include <memory>
#include <optional>

#include "sph/discretization.h"
#include "sph/region.h"

namespace resect {

// The box round the cells of all particles; empty if there are no particles. Fractions in regions
// refer to this box. The box of the organ's surface differs from this box by at most half a cell.
// Cost: a pass over the cells.
Aabb particleBox(const Discretization& cells);

// Computes the box for the first region that needs the box, and the surface for the first region
// that needs the surface. Keeps both for later regions. The surface is the iso surface of the cells
// at iso level 50. Depths are accurate to a quarter of a cell (collision/signed_distance.h). Making
// the surface costs as much as building an organ.
class RegionPlacer {
 public:
  // Keeps a reference to `cells`, which must outlive this object.
  explicit RegionPlacer(const Discretization& cells) : cells_(cells) {}

  // The region in world coordinates. Throws Error if the region names a landmark that the cells do
  // not have, or if it is limited in depth and the organ has no surface.
  Region operator()(Region region);

 private:
  const Discretization& cells_;
  std::optional<Aabb> box_;
  std::shared_ptr<const SignedDistance> skin_;
};

}  // namespace resect
