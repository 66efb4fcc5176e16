// Places a region in an organ at rest, so that Region::holds() can be called: converts fractions
// and landmarks to positions in the world, and adds the surface from which depths are measured.
#pragma once

#include <memory>
#include <optional>

#include "sph/discretization.h"
#include "sph/region.h"

namespace resect {

// The box round the cells of all particles, which is the box that fractions refer to. It agrees
// with the box of the organ's surface to half a cell. Empty without particles. Cost: a pass over
// the cells.
Aabb particleBox(const Discretization& cells);

// Box and surface are made for the first region that needs them and kept for later ones. The
// surface is the iso surface of the cells at level 50; depths are accurate to a quarter of a cell
// (collision/signed_distance.h). Cost of the surface: that of building an organ.
class RegionPlacer {
 public:
  // Keeps a reference to the cells.
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
