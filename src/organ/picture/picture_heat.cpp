#include "organ/picture/picture_heat.h"

#include <algorithm>

#include "organ/heat/heat_organ.h"
#include "tissue/stencil.h"

namespace resect {
namespace {

std::uint8_t toByte(double share) {
  return std::uint8_t(std::clamp(255 * share + 0.5, 0.0, 255.0));
}

}  // namespace

std::shared_ptr<const TissueMap> pictureHeat(const OperatedOrgan& organ) {
  const HeatField& heat = organ.organ.heat;
  auto map = std::make_shared<TissueMap>();
  if (heat.empty()) return map;
  const Lattice& lattice = heat.lattice();
  Vec3i low = lattice.dims, high = Vec3i::Constant(-1);
  for (const HeatedSpot& s : heat.spots()) {
    const Vec3i cell = lattice.cell(s.index);
    low = low.cwiseMin(cell);
    high = high.cwiseMax(cell);
  }
  low -= Vec3i::Ones(), high += Vec3i::Ones();
  map->low = lattice.centre(low).cast<float>();
  map->spacing = Vec3f::Constant(float(HeatField::kSpacing));
  map->dims = high - low + Vec3i::Ones();
  const std::size_t count = std::size_t(map->dims.prod());
  map->texels.assign(2 * count, 0);
  enum class Cell : std::uint8_t { Unknown, Tissue, Empty };
  std::vector<Cell> kind(count, Cell::Unknown);
  const auto texelOf = [&](const Vec3i& cell) {
    const Vec3i at = cell - low;
    return std::size_t((at.z() * map->dims.y() + at.y()) * map->dims.x() + at.x());
  };
  const Lattice& cells = organ.organ.rest.lattice;
  for (const HeatedSpot& s : heat.spots()) {
    const std::size_t texel = texelOf(lattice.cell(s.index));
    kind[texel] = Cell::Tissue;
    map->texels[2 * texel] = toByte(s.coagulated);
    map->texels[2 * texel + 1] = toByte(0.4 * (1 - s.water) + 0.6 * s.charred);
    const Vec3 rest = lattice.centre(lattice.cell(s.index));
    const auto cell = cells.cellAt(rest);
    if (cell && organ.tissue->solid(cells.index(*cell)))
      map->box.grow(Vec3(rest + organ.tissue->displacement(cells.index(*cell))));
  }
  // The surface lies between heated tissue and cells without tissue. These continue the tissue's
  // shares: else interpolation would halve them at the surface.
  for (const HeatedSpot& s : heat.spots()) {
    const Vec3i cell = lattice.cell(s.index);
    const std::size_t from = texelOf(cell);
    if (map->texels[2 * from] == 0) continue;
    for (int d = 0; d < kDirections; ++d) {
      const Vec3i beside = cell + offsetOf(d);
      const std::size_t to = texelOf(beside);
      if (kind[to] == Cell::Unknown)
        kind[to] = isTissue(organ.organ, lattice.centre(beside)) ? Cell::Tissue : Cell::Empty;
      if (kind[to] == Cell::Tissue) continue;
      for (const std::size_t k : {0u, 1u})
        map->texels[2 * to + k] = std::max(map->texels[2 * to + k], map->texels[2 * from + k]);
    }
  }
  if (!map->box.empty()) map->box = map->box.padded(2 * cells.spacing.x());
  return map;
}

}  // namespace resect
