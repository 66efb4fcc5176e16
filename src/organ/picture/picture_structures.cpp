#include "organ/picture/picture_structures.h"

#include <array>
#include <vector>

#include "anatomy/structure_kind.h"

namespace resect {
namespace {

// Rounds the corners of cells: each value becomes a mean with those `step` before and after it. The
// values at the borders are 0.
void smooth(std::vector<float>& values, std::size_t step) {
  const std::vector<float> before = values;
  for (std::size_t i = step; i + step < values.size(); ++i)
    values[i] = 0.6f * before[i] + 0.2f * (before[i - step] + before[i + step]);
}

}  // namespace

std::shared_ptr<const TissueMap> pictureStructures(const Organ& organ) {
  auto map = std::make_shared<TissueMap>();
  const Lattice& lattice = organ.rest.lattice;
  const auto labelled = [&](std::int64_t cell) {
    return organ.label(cell) > 0 && organ.rest.value[std::size_t(cell)] > 0;
  };
  Vec3i low = lattice.dims, high = Vec3i::Constant(-1);
  for (std::int64_t cell = 0; cell < lattice.cellCount(); ++cell) {
    if (!labelled(cell)) continue;
    low = low.cwiseMin(lattice.cell(cell));
    high = high.cwiseMax(lattice.cell(cell));
  }
  if (high.x() < 0) return map;
  std::array<std::size_t, 256> channel{};
  for (int label = 1; label < 256; ++label)
    channel[std::size_t(label)] =
        structureKind(organ.rest.labelName(label)) == StructureKind::Tumour ? 0 : 1;
  // A border of nothing, since a texture repeats its outermost texels for ever.
  low -= Vec3i::Constant(2), high += Vec3i::Constant(2);
  map->low = lattice.centre(low).cast<float>();
  map->spacing = lattice.spacing.cast<float>();
  map->dims = high - low + Vec3i::Ones();
  std::vector<float> share(2 * std::size_t(map->dims.prod()), 0);
  std::size_t texel = 0;
  for (int z = low.z(); z <= high.z(); ++z)
    for (int y = low.y(); y <= high.y(); ++y)
      for (int x = low.x(); x <= high.x(); ++x, texel += 2) {
        if (!lattice.contains({x, y, z})) continue;
        const std::int64_t cell = lattice.index({x, y, z});
        if (labelled(cell)) share[texel + channel[organ.label(cell)]] = 1;
      }
  for (const std::size_t step : {std::size_t(2), 2 * std::size_t(map->dims.x()),
                                 2 * std::size_t(map->dims.x()) * std::size_t(map->dims.y())})
    smooth(share, step);
  for (const float s : share) map->texels.push_back(std::uint8_t(255 * s + 0.5f));
  return map;
}

}  // namespace resect
