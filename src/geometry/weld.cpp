#include "geometry/weld.h"

#include <algorithm>
#include <numeric>

namespace resect {
namespace {

// parent[i] leads to the smallest index of the points that are the same as i.
std::int32_t findFirst(std::vector<std::int32_t>& parent, std::int32_t i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

void join(std::vector<std::int32_t>& parent, std::int32_t a, std::int32_t b) {
  a = findFirst(parent, a);
  b = findFirst(parent, b);
  if (a != b) parent[std::max(a, b)] = std::min(a, b);
}

std::vector<std::int32_t> twins(const std::vector<Vec3>& points, double tolerance) {
  std::vector<std::int32_t> parent(points.size()), order(points.size());
  std::iota(parent.begin(), parent.end(), 0);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
    for (int k = 0; k < 3; ++k)
      if (points[a][k] != points[b][k]) return points[a][k] < points[b][k];
    return a < b;
  });
  for (std::size_t i = 0; i + 1 < order.size(); ++i)
    if (points[order[i]] == points[order[i + 1]]) join(parent, order[i], order[i + 1]);
  if (tolerance <= 0) return parent;
  // Sweep along x over one representative per position.
  std::erase_if(order, [&](std::int32_t i) { return findFirst(parent, i) != i; });
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      const Vec3 gap = points[order[j]] - points[order[i]];
      if (gap.x() > tolerance) break;
      if (gap.squaredNorm() <= tolerance * tolerance) join(parent, order[i], order[j]);
    }
  return parent;
}

}  // namespace

TriangleMesh weld(const TriangleMesh& mesh, double relativeTolerance, WeldReport* report) {
  const double tolerance =
      relativeTolerance > 0 ? relativeTolerance * bounds(mesh).size().norm() : 0;
  std::vector<std::int32_t> parent = twins(mesh.points, tolerance);

  std::vector<char> used(mesh.points.size(), 0);
  TriangleMesh result;
  result.triangles.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    const Triangle u{findFirst(parent, t[0]), findFirst(parent, t[1]), findFirst(parent, t[2])};
    if (u[0] == u[1] || u[1] == u[2] || u[2] == u[0]) continue;
    result.triangles.push_back(u);
    for (const std::int32_t i : u) used[i] = 1;
  }

  WeldReport counts;
  counts.degenerateTriangles = int(mesh.triangles.size() - result.triangles.size());
  std::vector<std::int32_t> newIndex(mesh.points.size(), -1);
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    if (parent[i] != std::int32_t(i)) {
      ++counts.mergedPoints;
    } else if (!used[i]) {
      ++counts.unusedPoints;
    } else {
      newIndex[i] = std::int32_t(result.points.size());
      result.points.push_back(mesh.points[i]);
    }
  }
  for (Triangle& t : result.triangles)
    for (std::int32_t& i : t) i = newIndex[i];
  if (report) *report = counts;
  return result;
}

}  // namespace resect
