#include "wound/brick_window.h"

#include <algorithm>

namespace resect {
namespace {

// The part of a neighbouring brick's 64 nodes that lies in the window.
void copy(const float* from, const Vec3i& step, std::array<float, BrickWindow::kNodes>& to) {
  const auto low = [&](int a) { return step[a] < 0 ? kBrickNodes - BrickWindow::kHalo : 0; };
  const auto high = [&](int a) {
    return step[a] > 0 ? BrickWindow::kSide - BrickWindow::kHalo - kBrickNodes : kBrickNodes;
  };
  for (int z = low(2); z < high(2); ++z)
    for (int y = low(1); y < high(1); ++y) {
      const float* row = from + (z * 4 + y) * 4;
      float* out = to.data() + BrickWindow::index(Vec3i(0, y, z) + kBrickNodes * step);
      for (int x = low(0); x < high(0); ++x) out[x] = row[x];
    }
}

}  // namespace

BrickWindow::BrickWindow(const ColourField& field, const SeveredEdges& wound, const Vec3i& brick,
                         float iso) {
  value.fill(0);
  for (auto& along : severed) along.fill(kWhole);
  for (int d = 0; d < 27; ++d) {
    const Vec3i step(d % 3 - 1, d / 3 % 3 - 1, d / 9 - 1), b = brick + step;
    if ((b.array() < 0).any() || (b.array() >= field.brickDims().array()).any()) continue;
    copy(field.nodes(b), step, value);
    const std::int64_t index = field.brickIndex(b);
    for (int a = 0; a < 3; ++a)
      if (wound.mask(index, a) != 0) copy(wound.shares(index, a), step, severed[std::size_t(a)]);
  }
  grid = {kBrickNodes * brick - Vec3i::Constant(BrickWindow::kHalo),
          Vec3i::Constant(BrickWindow::kSide),
          iso,
          value.data(),
          {severed[0].data(), severed[1].data(), severed[2].data()},
          &wound};
}

BoxWindow::BoxWindow(const ColourField& field, const SeveredEdges& wound, const IndexBox& nodes,
                     float iso)
    : value(nodes.count(), 0) {
  for (auto& along : severed) along.assign(nodes.count(), kWhole);
  const Vec3i end = (nodes.low + nodes.dims).cwiseMin(kBrickNodes * field.brickDims());
  const Vec3i first = nodes.low.cwiseMax(0) / kBrickNodes;
  const Vec3i last = (end + Vec3i::Constant(kBrickNodes - 1)) / kBrickNodes;
  for (int z = first.z(); z < last.z(); ++z)
    for (int y = first.y(); y < last.y(); ++y)
      for (int x = first.x(); x < last.x(); ++x) {
        const Vec3i brick(x, y, z), at = kBrickNodes * brick;
        const Vec3i low = (nodes.low - at).cwiseMax(0);
        const Vec3i high = (end - at).cwiseMin(kBrickNodes);
        const auto copyRows = [&](const float* from, std::vector<float>& to) {
          for (int k = low.z(); k < high.z(); ++k)
            for (int j = low.y(); j < high.y(); ++j)
              std::copy_n(from + (k * kBrickNodes + j) * kBrickNodes + low.x(), high.x() - low.x(),
                          to.begin() + nodes.index(at + Vec3i(low.x(), j, k)));
        };
        copyRows(field.nodes(brick), value);
        const std::int64_t index = field.brickIndex(brick);
        for (int a = 0; a < 3; ++a)
          if (wound.mask(index, a) != 0) copyRows(wound.shares(index, a), severed[std::size_t(a)]);
      }
  grid = {nodes.low,
          nodes.dims,
          iso,
          value.data(),
          {severed[0].data(), severed[1].data(), severed[2].data()},
          &wound};
}

}  // namespace resect
