#include "geometry/topology.h"

#include <algorithm>
#include <numeric>

#include "base/stop.h"

namespace resect {
namespace {

// The edges of a mesh, grouped by their lower point index and sorted within a group. An edge is
// stored as its higher index, with the direction of use as the lowest bit: 4 bytes for each of a
// triangle's three edges, written once and read once.
struct EdgesByCorner {
  std::vector<std::uint32_t> end;  // per corner, one past its edges
  std::vector<std::uint32_t> edges;
};

EdgesByCorner edgesByCorner(const TriangleMesh& mesh) {
  const auto forEachEdge = [&](auto&& visit) {
    for (const Triangle& t : mesh.triangles)
      for (int i = 0; i < 3; ++i) visit(std::uint32_t(t[i]), std::uint32_t(t[(i + 1) % 3]));
  };
  EdgesByCorner result;
  std::vector<std::uint32_t>& next = result.end;  // where the group's next edge is written
  next.assign(mesh.points.size() + 1, 0);
  forEachEdge([&](std::uint32_t a, std::uint32_t b) { ++next[std::min(a, b) + 1]; });
  for (std::size_t i = 1; i < next.size(); ++i) next[i] += next[i - 1];
  result.edges.resize(3 * mesh.triangles.size());
  forEachEdge([&](std::uint32_t a, std::uint32_t b) {
    result.edges[next[std::min(a, b)]++] = a < b ? b << 1 : a << 1 | 1;
  });
  next.pop_back();
  std::uint32_t first = 0;
  for (const std::uint32_t end : next) {
    std::sort(result.edges.begin() + first, result.edges.begin() + end);
    first = end;
  }
  checkStop();
  return result;
}

std::int32_t findRoot(std::vector<std::int32_t>& parent, std::int32_t i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

}  // namespace

Topology topology(const TriangleMesh& mesh) {
  requireTriangles(mesh);
  checkStop();
  Topology result;
  const auto [ends, edges] = edgesByCorner(mesh);
  std::size_t first = 0;
  for (std::size_t corner = 0; corner < ends.size(); ++corner)
    while (first < ends[corner]) {
      const std::uint32_t other = edges[first] >> 1;
      std::size_t last = first;
      int balance = 0;
      for (; last < ends[corner] && edges[last] >> 1 == other; ++last)
        balance += edges[last] & 1 ? -1 : 1;
      const std::size_t uses = last - first;
      if (uses % 2 == 1) {
        if (!result.firstBoundaryPoint)
          result.firstBoundaryPoint = 0.5 * (mesh.points[corner] + mesh.points[other]);
        ++result.boundaryEdges;
      }
      if (uses > 2) ++result.nonManifoldEdges;
      if (std::abs(balance) > int(uses % 2)) ++result.unorientedEdges;
      first = last;
    }
  checkStop();
  pointComponents(mesh, &result.components);
  return result;
}

std::vector<std::int32_t> pointComponents(const TriangleMesh& mesh, int* count) {
  requireTriangles(mesh);
  std::vector<std::int32_t> parent(mesh.points.size());
  std::iota(parent.begin(), parent.end(), 0);
  std::vector<char> used(mesh.points.size(), 0);
  for (const Triangle& t : mesh.triangles) {
    const std::int32_t a = findRoot(parent, t[0]);
    const std::int32_t b = findRoot(parent, t[1]);
    const std::int32_t c = findRoot(parent, t[2]);
    parent[a] = parent[b] = parent[c] = std::min({a, b, c});
    used[t[0]] = used[t[1]] = used[t[2]] = 1;
  }
  std::vector<std::int32_t> component(mesh.points.size(), -1);
  std::int32_t next = 0;
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    if (!used[i]) continue;
    // A root is the smallest index of its piece, so it was numbered before all others.
    const std::int32_t root = findRoot(parent, std::int32_t(i));
    component[i] = root == std::int32_t(i) ? next++ : component[root];
  }
  if (count) *count = next;
  return component;
}

std::vector<TriangleMesh> splitComponents(const TriangleMesh& mesh) {
  int count = 0;
  const std::vector<std::int32_t> component = pointComponents(mesh, &count);
  checkStop();
  std::vector<TriangleMesh> pieces(count);
  std::vector<std::int32_t> newIndex(mesh.points.size(), -1);
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    if (component[i] < 0) continue;
    TriangleMesh& piece = pieces[component[i]];
    newIndex[i] = std::int32_t(piece.points.size());
    piece.points.push_back(mesh.points[i]);
  }
  for (const Triangle& t : mesh.triangles)
    pieces[component[t[0]]].triangles.push_back({newIndex[t[0]], newIndex[t[1]], newIndex[t[2]]});
  return pieces;
}

}  // namespace resect
