#include "organ/vertex_labels.h"

#include <limits>

namespace resect {
namespace {

struct Nearest {
  std::int64_t cell = -1;
  double squared = std::numeric_limits<double>::infinity();  // distance, m^2
};

// The nearest among the cells up to `reach` away from one along each axis.
Nearest nearestRound(const Lattice& lattice, std::span<const std::uint8_t> alive, const Vec3i& at,
                     int reach, const Vec3& point) {
  Nearest nearest;
  const Vec3i low = (at.array() - reach).max(0);
  const Vec3i high = (at.array() + reach).min(lattice.dims.array() - 1);
  for (int z = low.z(); z <= high.z(); ++z)
    for (int y = low.y(); y <= high.y(); ++y)
      for (int x = low.x(); x <= high.x(); ++x) {
        const std::int64_t cell = lattice.index({x, y, z});
        if (!alive[std::size_t(cell)]) continue;
        const double squared = (lattice.centre({x, y, z}) - point).squaredNorm();
        if (squared < nearest.squared) nearest = {cell, squared};
      }
  return nearest;
}

}  // namespace

std::int64_t nearestParticle(const Lattice& lattice, std::span<const std::uint8_t> alive,
                             const Vec3& point) {
  const Vec3 place = lattice.toCellSpace(point).array().round();
  if (!((place.array() >= -2).all() &&
        (place.array() < lattice.dims.cast<double>().array() + 2).all()))
    return -1;
  const Vec3i at = place.cast<int>();
  const Nearest beside = nearestRound(lattice, alive, at, 1, point);
  // Cells farther away are at least one and a half cells away.
  const double sure = 1.5 * lattice.spacing.minCoeff();
  if (beside.squared <= sure * sure) return beside.cell;
  return nearestRound(lattice, alive, at, 2, point).cell;
}

std::vector<std::uint8_t> vertexLabels(const Organ& organ) {
  const std::span<const Vec3f> points = organ.surface.points();
  std::vector<std::uint8_t> labels(points.size(), 0);
  if (organ.rest.label.empty()) return labels;
  std::vector<std::uint8_t> known(points.size(), 0);
  organ.surface.visitBindings([&](std::int32_t first, std::span<const VertexBinding> bindings) {
    for (std::size_t i = 0; i < bindings.size(); ++i) {
      const VertexBinding& binding = bindings[i];
      if (binding.count == 0) continue;
      int most = 0;
      for (int k = 1; k < binding.count; ++k)
        if (binding.weight[std::size_t(k)] > binding.weight[std::size_t(most)]) most = k;
      labels[std::size_t(first) + i] = organ.label(binding.cell[std::size_t(most)]);
      known[std::size_t(first) + i] = 1;
    }
  });
  for (const Triangle& t : organ.surface.triangles()) {
    if (t[0] == t[1]) continue;  // a hole
    for (const auto v : t) {
      if (known[std::size_t(v)]) continue;
      known[std::size_t(v)] = 1;
      const std::int64_t cell =
          nearestParticle(organ.rest.lattice, organ.alive, points[std::size_t(v)].cast<double>());
      if (cell >= 0) labels[std::size_t(v)] = organ.label(cell);
    }
  }
  return labels;
}

}  // namespace resect
