#include "organ/pieces.h"

#include <algorithm>
#include <numeric>

#include "collision/inside.h"
#include "geometry/measures.h"
#include "geometry/topology.h"

namespace resect {
namespace {

std::vector<TriangleMesh> largestFirst(std::vector<TriangleMesh> pieces) {
  std::vector<double> volumes;
  for (const TriangleMesh& piece : pieces) volumes.push_back(volume(piece));
  std::vector<std::size_t> order(pieces.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](auto a, auto b) { return volumes[a] > volumes[b]; });
  std::vector<TriangleMesh> sorted;
  for (const std::size_t i : order) sorted.push_back(std::move(pieces[i]));
  return sorted;
}

}  // namespace

std::vector<TriangleMesh> bodies(const TriangleMesh& surface) {
  std::vector<TriangleMesh> skins, cavities;
  for (TriangleMesh& piece : splitComponents(surface))
    (volume(piece) >= 0 ? skins : cavities).push_back(std::move(piece));

  std::vector<double> volumes;
  for (const TriangleMesh& skin : skins) volumes.push_back(volume(skin));
  std::vector<std::size_t> order(skins.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](auto a, auto b) { return volumes[a] > volumes[b]; });

  std::vector<TriangleMesh> result;
  for (const std::size_t i : order) result.push_back(skins[i]);
  for (const TriangleMesh& cavity : cavities) {
    // The smallest skin round a point of the cavity; the surface never touches itself, so one point
    // decides.
    for (std::size_t i = result.size(); i-- > 0;)
      if (insideFlags(skins[order[i]], std::span(cavity.points.data(), 1))[0]) {
        append(result[i], cavity);
        break;
      }
  }
  return result;
}

std::vector<std::int32_t> tissuePieces(const Organ& organ, int* count) {
  const Vec3i dims = organ.field.nodeDims();
  const float iso = organ.surface.iso();
  const std::int64_t step[3] = {1, dims.x(), std::int64_t(dims.x()) * dims.y()};
  constexpr std::int32_t kOutside = -1, kUnseen = -2;
  std::vector<std::int32_t> piece(std::size_t(step[2] * dims.z()), kOutside);
  for (std::int64_t b = 0; b < organ.field.brickCount(); ++b) {
    if (organ.field.slot(b) == ColourField::kEmpty) continue;
    const Vec3i brick = organ.field.brick(b);
    const float* nodes = organ.field.nodes(brick);
    for (int i = 0; i < kBrickSize; ++i) {
      const Vec3i n = kBrickNodes * brick + Vec3i(i & 3, i >> 2 & 3, i >> 4);
      if (nodes[i] >= iso) piece[std::size_t(n.x() + n.y() * step[1] + n.z() * step[2])] = kUnseen;
    }
  }
  int pieces = 0;
  std::vector<std::int64_t> stack;
  for (std::int64_t first = 0; first < std::int64_t(piece.size()); ++first) {
    if (piece[std::size_t(first)] != kUnseen) continue;
    piece[std::size_t(first)] = pieces;
    stack.push_back(first);
    while (!stack.empty()) {
      const std::int64_t i = stack.back();
      stack.pop_back();
      const Vec3i n(int(i % dims.x()), int(i / dims.x() % dims.y()), int(i / step[2]));
      for (int a = 0; a < 3; ++a)
        for (const int side : {0, 1}) {
          const Vec3i lower = n - side * Vec3i::Unit(a);
          if (lower[a] < 0 || lower[a] + 1 >= dims[a]) continue;
          const std::int64_t to = side ? i - step[a] : i + step[a];
          if (piece[std::size_t(to)] != kUnseen || organ.severed.at(lower, a) != kWhole) continue;
          piece[std::size_t(to)] = pieces;
          stack.push_back(to);
        }
    }
    ++pieces;
  }
  if (count) *count = pieces;
  return piece;
}

std::vector<TriangleMesh> bodies(const Organ& organ) { return bodies(organ, organ.surface.mesh()); }

std::vector<TriangleMesh> bodies(const Organ& organ, const TriangleMesh& surface) {
  if (organ.severed.empty()) return bodies(surface);
  int count = 0;
  const std::vector<std::int32_t> pieceOf = tissuePieces(organ, &count);
  const std::vector<Vec3i> anchors = organ.surface.anchorNodes(organ.field);
  const Vec3i dims = organ.field.nodeDims();
  std::vector<TriangleMesh> pieces(std::size_t(count), TriangleMesh{});
  std::vector<std::int32_t> piece(surface.points.size()), number(surface.points.size());
  for (std::size_t p = 0; p < surface.points.size(); ++p) {
    const Vec3i& n = anchors[p];
    const std::int64_t node =
        n.x() + std::int64_t(dims.x()) * (n.y() + std::int64_t(dims.y()) * n.z());
    piece[p] = pieceOf[std::size_t(node)];
    TriangleMesh& mesh = pieces[std::size_t(piece[p])];
    number[p] = std::int32_t(mesh.points.size());
    mesh.points.push_back(surface.points[p]);
  }
  for (const Triangle& t : surface.triangles)
    pieces[std::size_t(piece[std::size_t(t[0])])].triangles.push_back(
        {number[std::size_t(t[0])], number[std::size_t(t[1])], number[std::size_t(t[2])]});
  return largestFirst(std::move(pieces));
}

}  // namespace resect
