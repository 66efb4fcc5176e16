#include "geometry/repair/weld.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <numeric>
#include <random>

namespace resect {
namespace {

// Union-find: parent[i] leads to the smallest index of the points equal to i.
std::int32_t findFirst(std::vector<std::int32_t>& parent, std::int32_t i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

void join(std::vector<std::int32_t>& parent, std::int32_t a, std::int32_t b) {
  a = findFirst(parent, a);
  b = findFirst(parent, b);
  if (a != b) parent[std::max(a, b)] = std::min(a, b);
}

// Uniform over all 64 bits (the finaliser of MurmurHash3, Appleby); equal for equal positions, so 0
// and -0 hash alike. Seeded differently in each run, so that no file can be made whose points all
// collide; the result of welding does not depend on the seed.
std::uint64_t hashOf(const Vec3& p) {
  static const std::uint64_t start = std::uint64_t(std::random_device()()) << 32 | 0x9e3779b9u;
  std::uint64_t hash = start;
  for (int k = 0; k < 3; ++k) {
    hash ^= std::bit_cast<std::uint64_t>(p[k] + 0.0);
    hash = (hash ^ hash >> 33) * 0xff51afd7ed558ccdu;
    hash = (hash ^ hash >> 33) * 0xc4ceb9fe1a85ec53u;
  }
  return hash ^ hash >> 33;
}

// For each point the first one at exactly the same position. Aims at one probe of a hash table that
// is at most half full, 8 bytes a point.
std::vector<std::int32_t> firstsOfPlaces(const std::vector<Vec3>& points) {
  constexpr std::int32_t kNobody = -1;
  std::vector<std::int32_t> table(std::bit_ceil(2 * points.size() + 1), kNobody);
  std::vector<std::int32_t> first(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::size_t slot = hashOf(points[i]) & (table.size() - 1);
    while (table[slot] != kNobody && points[table[slot]] != points[i])
      slot = (slot + 1) & (table.size() - 1);
    if (table[slot] == kNobody) table[slot] = std::int32_t(i);
    first[i] = table[slot];
  }
  return first;
}

std::vector<std::int32_t> twins(const std::vector<Vec3>& points, double tolerance) {
  std::vector<std::int32_t> parent = firstsOfPlaces(points);
  if (tolerance <= 0) return parent;
  // Sweep along x over one representative per position.
  std::vector<std::int32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::erase_if(order, [&](std::int32_t i) { return parent[i] != i; });
  std::ranges::sort(order, [&](std::int32_t a, std::int32_t b) {
    return points[a].x() != points[b].x() ? points[a].x() < points[b].x() : a < b;
  });
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
