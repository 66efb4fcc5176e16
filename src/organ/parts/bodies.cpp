#include "organ/parts/bodies.h"

#include <algorithm>
#include <numeric>

#include "base/stop.h"
#include "collision/inside.h"
#include "geometry/measures.h"
#include "geometry/topology.h"

namespace resect {
namespace {

// The piece at the node of a cell's centre; if that lies outside the surface, at the nearest node
// of the cell in tissue; -1 if there is none.
std::int32_t pieceOfCell(const Organ& organ, const std::vector<std::int32_t>& pieceOf,
                         std::int64_t cell) {
  const int refine = organ.field.refine();
  const Vec3i dims = organ.field.nodeDims();
  const Vec3i centre = refine * (organ.rest.lattice.cell(cell) + Vec3i::Constant(2));
  std::int32_t piece = -1;
  int nearest = 1 << 20;
  for (int z = -refine; z <= refine; ++z)
    for (int y = -refine; y <= refine; ++y)
      for (int x = -refine; x <= refine; ++x) {
        const Vec3i n = centre + Vec3i(x, y, z);
        const int distance = x * x + y * y + z * z;
        if (distance >= nearest || (n.array() < 0).any() || (n.array() >= dims.array()).any())
          continue;
        const std::int32_t found = pieceOf[std::size_t(
            n.x() + std::int64_t(dims.x()) * (n.y() + std::int64_t(dims.y()) * n.z()))];
        if (found < 0) continue;
        piece = found;
        nearest = distance;
      }
  return piece;
}

// Merges each piece without a particle into one that it touches across a cut; returns the resulting
// number of each piece.
std::vector<std::int32_t> joinSlivers(const Organ& organ, const std::vector<std::int32_t>& pieceOf,
                                      std::vector<std::uint8_t> holdsParticle) {
  const Vec3i dims = organ.field.nodeDims();
  const std::int64_t step[3] = {1, dims.x(), std::int64_t(dims.x()) * dims.y()};
  std::vector<std::int32_t> joined(holdsParticle.size());
  std::iota(joined.begin(), joined.end(), 0);
  for (bool again = true; again;) {
    again = false;
    for (std::int64_t i = 0; i < std::int64_t(pieceOf.size()); ++i)
      for (int a = 0; a < 3; ++a) {
        if (i / step[a] % dims[a] + 1 >= dims[a]) continue;
        const std::int32_t p = pieceOf[std::size_t(i)], q = pieceOf[std::size_t(i + step[a])];
        if (p < 0 || q < 0 || p == q || holdsParticle[p] == holdsParticle[q]) continue;
        const auto [sliver, body] = holdsParticle[p] ? std::pair(q, p) : std::pair(p, q);
        joined[sliver] = joined[body];
        holdsParticle[sliver] = 1;
        again = true;
      }
  }
  return joined;
}

}  // namespace

std::vector<TriangleMesh> bodies(const TriangleMesh& surface) {
  std::vector<TriangleMesh> skins, cavities;
  for (TriangleMesh& piece : splitComponents(surface))
    (volume(piece) >= 0 ? skins : cavities).push_back(std::move(piece));

  std::vector<double> volumes(skins.size());
  std::ranges::transform(skins, volumes.begin(), volume);
  std::vector<std::size_t> order(skins.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](auto a, auto b) { return volumes[a] > volumes[b]; });

  std::vector<TriangleMesh> result;
  result.reserve(skins.size());
  for (const std::size_t i : order) result.push_back(skins[i]);
  for (const TriangleMesh& cavity : cavities) {
    // The smallest surface round a point of the cavity; the surface never touches itself, so one
    // point decides.
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
      checkStop();
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

std::vector<Body> bodies(const Organ& organ) { return bodies(organ, organ.surface.mesh()); }

std::vector<Body> bodies(const Organ& organ, const TriangleMesh& surface) {
  int count = 0;
  const std::vector<std::int32_t> pieceOf = tissuePieces(organ, &count);
  const Vec3i dims = organ.field.nodeDims();
  const auto pieceAt = [&](const Vec3i& n) {
    return pieceOf[std::size_t(n.x() +
                               std::int64_t(dims.x()) * (n.y() + std::int64_t(dims.y()) * n.z()))];
  };
  std::vector<Body> pieces(std::size_t(count), Body{});
  for (std::int64_t cell = 0; cell < organ.rest.lattice.cellCount(); ++cell) {
    if (!organ.alive[cell] || !organ.rest.inside[cell]) continue;
    const std::int32_t piece = pieceOfCell(organ, pieceOf, cell);
    if (piece < 0) continue;
    checkStop();
    ++pieces[piece].particles;
    const double tissue = particleVolume(organ.rest, cell);
    pieces[piece].tissue += tissue;
    const std::size_t label = organ.label(cell);
    if (pieces[piece].tissueOf.size() <= label) pieces[piece].tissueOf.resize(label + 1);
    pieces[piece].tissueOf[label] += tissue;
  }
  std::vector<std::uint8_t> holdsParticle(pieces.size());
  std::ranges::transform(pieces, holdsParticle.begin(),
                         [](const Body& piece) { return piece.particles > 0; });
  const std::vector<std::int32_t> joined = joinSlivers(organ, pieceOf, std::move(holdsParticle));

  checkStop();
  const std::vector<Vec3i> anchors = organ.surface.anchorNodes(organ.field);
  std::vector<std::int32_t> piece(surface.points.size()), number(surface.points.size());
  for (std::size_t p = 0; p < surface.points.size(); ++p) {
    piece[p] = joined[pieceAt(anchors[p])];
    TriangleMesh& mesh = pieces[piece[p]].mesh;
    number[p] = std::int32_t(mesh.points.size());
    mesh.points.push_back(surface.points[p]);
  }
  for (const Triangle& t : surface.triangles)
    pieces[piece[t[0]]].mesh.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
  checkStop();
  std::erase_if(pieces, [](const Body& body) { return body.mesh.triangles.empty(); });

  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < pieces.size(); ++i) order.push_back({-volume(pieces[i].mesh), i});
  std::sort(order.begin(), order.end());
  std::vector<Body> sorted;
  sorted.reserve(pieces.size());
  for (const auto& [size, i] : order) sorted.push_back(std::move(pieces[i]));
  return sorted;
}

}  // namespace resect
