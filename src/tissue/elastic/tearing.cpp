// Finds the bonds and grips that tear.
#include <algorithm>
#include <array>
#include <bit>

#include "tissue/elastic/elastic_tissue.h"

namespace resect {
namespace {

// Per direction, the directions on the same side: bit e if direction e has a positive component
// along it.
constexpr std::array<std::uint32_t, kDirections> kSide = [] {
  std::array<std::uint32_t, kDirections> side{};
  for (int d = 0; d < kDirections; ++d)
    for (int e = 0; e < kDirections; ++e) {
      int dot = 0;
      for (int axis = 0; axis < 3; ++axis) dot += offsetAlong(d, axis) * offsetAlong(e, axis);
      if (dot > 0) side[std::size_t(d)] |= 1u << e;
    }
  return side;
}();

}  // namespace

// Tissue tears where a tool pulls at it, and where cuts have left a strand: bonds stretched beyond
// their material's limit within some cells of a gripped one, or beyond twice the limit where two
// thirds of a cell's bonds to that side are gone. At most twenty per frame, so that a tear
// propagates over several frames. letGo: tools whose grip has slipped.
void ElasticTissue::findTears(std::span<const std::int32_t> letGo,
                              std::vector<TissueBond>& torn) const {
  constexpr int kReach = 4;
  constexpr double kStrand =
      2;  // beside a blade's edge tissue is stretched that far without tearing
  constexpr std::size_t kMost = 20;
  torn.clear();
  // Bonds torn in this frame are still set in the state.
  std::array<std::pair<std::int32_t, std::uint32_t>, 2 * kMost> gone;
  std::size_t goneCount = 0;
  const auto bondsOf = [&](std::int32_t i) {
    std::uint32_t bonds = state_.bonds[i];
    for (std::size_t k = 0; k < goneCount; ++k)
      if (gone[k].first == i) bonds &= ~gone[k].second;
    return bonds;
  };
  const auto tearBond = [&](std::int32_t i, int d, double times) {
    if (torn.size() == kMost || !(bondsOf(i) >> d & 1)) return;
    const double limit = state_.materials[state_.material[i]].tearStretch * times * state_.spacing;
    const std::int32_t j = i + state_.box.step[d];
    Vec3 along = state_.spacing * offsetOf(d).cast<double>();
    for (int a = 0; a < 3; ++a) along[a] += double(state_.u[a][j]) - state_.u[a][i];
    if (!(along.squaredNorm() > limit * limit * neighbourKind(d))) return;
    torn.push_back({state_.box.toLattice(i), d});
    gone[goneCount++] = {i, 1u << d};
    gone[goneCount++] = {j, 1u << opposite(d)};
  };
  Vec3i low = Vec3i::Constant(1 << 20), high = Vec3i::Constant(-1);
  for (const TissueSpring& spring : springs_.all()) {
    if (spring.tool < 0 || std::ranges::find(letGo, spring.tool) != letGo.end()) continue;
    const Vec3i at = state_.box.cell(spring.cell);
    low = low.cwiseMin(at - Vec3i::Constant(kReach));
    high = high.cwiseMax(at + Vec3i::Constant(kReach));
  }
  low = low.cwiseMax(0);
  high = high.cwiseMin(lattice_.dims - Vec3i::Ones());
  for (int z = low.z(); z <= high.z(); ++z)
    for (int y = low.y(); y <= high.y(); ++y)
      for (int x = low.x(); x <= high.x(); ++x)
        for (int d = kFirstForward; d < kDirections; ++d)
          tearBond(state_.box.index({x, y, z}), d, 1);

  for (const std::int32_t i : cut_) {
    std::uint32_t solid = 0;  // bit d: solid cell in direction d
    for (int d = 0; d < kDirections; ++d)
      solid |= std::uint32_t(state_.solid[i + state_.box.step[d]]) << d;
    for (int d = 0; d < kDirections; ++d) {
      const int bonds = std::popcount(bondsOf(i) & kSide[std::size_t(d)]);
      const int neighbours = std::popcount(solid & kSide[std::size_t(d)]);
      if (3 * bonds <= neighbours) tearBond(i, d, kStrand);
    }
  }
}

}  // namespace resect
