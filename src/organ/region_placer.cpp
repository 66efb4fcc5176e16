#include "organ/region_placer.h"

#include "base/error.h"
#include "surface/surface_tracker.h"

namespace resect {

Aabb particleBox(const Discretization& cells) {
  const Lattice& lattice = cells.lattice;
  Aabb box;
  for (std::int64_t cell = 0; cell < lattice.cellCount(); ++cell)
    if (cells.inside[std::size_t(cell)]) box.grow(lattice.centre(lattice.cell(cell)));
  if (box.empty()) return box;
  return {box.min - 0.5 * lattice.spacing, box.max + 0.5 * lattice.spacing};
}

Region RegionPlacer::operator()(Region region) {
  if (region.isPlaced()) return region;
  if (region.frame == Region::Frame::Organ || !region.landmark.empty()) {
    if (!box_) box_ = particleBox(cells_);
    region = inWorld(std::move(region), *box_, cells_.landmarks);
  }
  if (!region.asksDepth()) return region;
  if (!skin_) {
    constexpr int kRefine = 2;
    constexpr float kIso = 50;
    const TriangleMesh surface = ColourField::canHold(cells_.lattice, kRefine)
                                     ? buildFieldAndSurface(cells_, kRefine, kIso).surface.mesh()
                                     : TriangleMesh();
    if (surface.triangles.empty())
      throw error(
          "the organ has no surface from which a depth could be measured; use more cells, "
          "or a region without depth");
    const double spacing = cells_.lattice.spacing.minCoeff();
    skin_ = std::make_shared<const SignedDistance>(surface, spacing, 0.5 * spacing);
  }
  region.skin = skin_;
  return region;
}

}  // namespace resect
