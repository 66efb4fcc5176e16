#include "organ/skin/bind_vertex.h"

#include <algorithm>
#include <optional>
#include <tuple>

#include "tissue/stencil.h"

namespace resect {
namespace {

constexpr double kReach =
    1.5;  // cells; cells farther than that are not all among the 26 neighbours

struct Near {
  Vec3i cell;
  double squared;  // distance, cells^2
  int number = 0;  // of those at one distance the lowest comes first
};

// The nearest particle among the cells from low + from to low + to.
std::optional<Near> nearestParticle(const Vec3& at, int from, int to, const Lattice& lattice,
                                    const TissueModel& tissue) {
  const Vec3i low = at.array().floor().cast<int>();
  std::optional<Near> nearest;
  for (int z = from; z <= to; ++z)
    for (int y = from; y <= to; ++y)
      for (int x = from; x <= to; ++x) {
        const Vec3i cell = low + Vec3i(x, y, z);
        const double squared = (at - cell.cast<double>()).squaredNorm();
        if (nearest && squared >= nearest->squared) continue;
        if (lattice.contains(cell) && tissue.solid(lattice.index(cell))) nearest = {cell, squared};
      }
  return nearest;
}

}  // namespace

VertexBinding bindVertex(const Vec3f& vertex, const Lattice& lattice, const TissueModel& tissue) {
  const Vec3 at = lattice.toCellSpace(vertex.cast<double>());
  std::optional<Near> first = nearestParticle(at, 0, 1, lattice, tissue);
  if (!first) first = nearestParticle(at, -2, 3, lattice, tissue);
  if (!first) return {};

  double reach = std::max(kReach * kReach, 2 * first->squared);
  std::array<Near, 1 + kDirections> near;
  std::size_t found = 0;
  near[found++] = *first;
  const std::uint32_t bonds = tissue.bonds(lattice.index(first->cell));
  for (int d = 0; d < kDirections; ++d) {
    if (!(bonds >> d & 1)) continue;
    const Vec3i cell = first->cell + offsetOf(d);
    const double squared = (at - cell.cast<double>()).squaredNorm();
    if (squared < reach) near[found++] = {cell, squared, d};
  }
  const std::size_t wanted = std::min<std::size_t>(found, VertexBinding::kMost + 1);
  std::partial_sort(near.begin() + 1, near.begin() + std::ptrdiff_t(wanted),
                    near.begin() + std::ptrdiff_t(found), [](const Near& a, const Near& b) {
                      return std::tie(a.squared, a.number) < std::tie(b.squared, b.number);
                    });

  // The first particle that is left out has no weight, so none jumps as the vertex's place changes.
  if (found > VertexBinding::kMost)
    reach = std::min(reach, near[std::size_t(VertexBinding::kMost)].squared);
  VertexBinding to;
  double sum = 0;
  std::array<double, VertexBinding::kMost> weight;
  for (std::size_t i = 0; i < std::min(found, weight.size()) && (i == 0 || near[i].squared < reach);
       ++i) {
    const double share = std::max(1 - near[i].squared / reach, 1e-3);
    weight[i] = share * share;
    sum += weight[i];
    to.cell[i] = std::int32_t(lattice.index(near[i].cell));
    ++to.count;
  }
  for (std::size_t i = 0; i < std::size_t(to.count); ++i) to.weight[i] = float(weight[i] / sum);
  return to;
}

}  // namespace resect
