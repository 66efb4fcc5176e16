#include "organ/picture/picture_heat.h"

#include <algorithm>

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
  map->texels.assign(2 * std::size_t(map->dims.prod()), 0);
  const Lattice& cells = organ.organ.rest.lattice;
  for (const HeatedSpot& s : heat.spots()) {
    const Vec3i at = lattice.cell(s.index) - low;
    const std::size_t texel =
        std::size_t((at.z() * map->dims.y() + at.y()) * map->dims.x() + at.x());
    map->texels[2 * texel] = toByte(s.coagulated);
    map->texels[2 * texel + 1] = toByte(s.charred);
    const Vec3 rest = lattice.centre(lattice.cell(s.index));
    const auto cell = cells.cellAt(rest);
    if (cell && organ.tissue->solid(cells.index(*cell)))
      map->box.grow(Vec3(rest + organ.tissue->displacement(cells.index(*cell))));
  }
  if (!map->box.empty()) map->box = map->box.padded(2 * cells.spacing.x());
  return map;
}

}  // namespace resect
