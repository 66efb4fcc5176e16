#include "geometry/repair/hole.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <queue>

namespace resect {
namespace {

constexpr std::size_t kLongestExactLoop = 300;  // 300^3 / 6 = 4.5 million triangles tried

struct DirectedEdge {
  std::int32_t from, to;
  bool operator<(const DirectedEdge& e) const { return from != e.from ? from < e.from : to < e.to; }
};

// Each edge without an opposite, reversed: the edges that the filling must contain.
std::vector<DirectedEdge> missingEdges(const TriangleMesh& mesh) {
  struct Use {
    DirectedEdge edge;  // from < to
    int direction;
  };
  std::vector<Use> uses;
  uses.reserve(3 * mesh.triangles.size());
  for (const Triangle& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) {
      const std::int32_t a = t[i], b = t[(i + 1) % 3];
      uses.push_back({{std::min(a, b), std::max(a, b)}, a < b ? 1 : -1});
    }
  std::sort(uses.begin(), uses.end(), [](const Use& a, const Use& b) { return a.edge < b.edge; });
  std::vector<DirectedEdge> missing;
  for (std::size_t first = 0; first < uses.size();) {
    std::size_t last = first;
    int balance = 0;
    for (; last < uses.size() && !(uses[first].edge < uses[last].edge); ++last)
      balance += uses[last].direction;
    const DirectedEdge e = uses[first].edge;
    for (; balance > 0; --balance) missing.push_back({e.to, e.from});
    for (; balance < 0; ++balance) missing.push_back(e);
    first = last;
  }
  std::sort(missing.begin(), missing.end());
  return missing;
}

double triangleArea(const Vec3& a, const Vec3& b, const Vec3& c) {
  return 0.5 * (b - a).cross(c - a).norm();
}

void fillWithLeastArea(std::span<const Vec3> points, std::span<const std::int32_t> loop,
                       std::vector<Triangle>& triangles) {
  const std::size_t n = loop.size();
  const auto at = [&](std::size_t i) -> const Vec3& { return points[loop[i]]; };
  // least[i * n + k]: least area over the corners i..k; apex: the corner that goes with edge (i,
  // k).
  std::vector<double> least(n * n, 0);
  std::vector<std::uint16_t> apex(n * n, 0);
  for (std::size_t span = 2; span < n; ++span)
    for (std::size_t i = 0; i + span < n; ++i) {
      const std::size_t k = i + span;
      double best = std::numeric_limits<double>::infinity();
      for (std::size_t j = i + 1; j < k; ++j) {
        const double size = least[i * n + j] + least[j * n + k] + triangleArea(at(i), at(j), at(k));
        if (size < best || j == i + 1) best = size, apex[i * n + k] = std::uint16_t(j);
      }
      least[i * n + k] = best;
    }
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, n - 1}};
  while (!open.empty()) {
    const auto [i, k] = open.back();
    open.pop_back();
    if (k - i < 2) continue;
    const std::size_t j = apex[i * n + k];
    triangles.push_back({loop[i], loop[j], loop[k]});
    open.emplace_back(i, j);
    open.emplace_back(j, k);
  }
}

// Clips ears, always the one with the shortest new edge, until `length` corners are left.
std::vector<std::int32_t> shorten(std::span<const Vec3> points, std::span<const std::int32_t> loop,
                                  std::size_t length, std::vector<Triangle>& triangles) {
  const std::size_t n = loop.size();
  struct Ear {
    double diagonal;
    std::size_t corner, version;
    bool operator<(const Ear& e) const {  // for a priority queue with the shortest first
      return diagonal != e.diagonal ? diagonal > e.diagonal : corner > e.corner;
    }
  };
  std::vector<std::size_t> previous(n), next(n), version(n, 0);
  std::vector<char> gone(n, 0);
  std::priority_queue<Ear> ears;
  const auto offer = [&](std::size_t i) {
    ears.push({(points[loop[next[i]]] - points[loop[previous[i]]]).norm(), i, ++version[i]});
  };
  for (std::size_t i = 0; i < n; ++i) {
    previous[i] = (i + n - 1) % n;
    next[i] = (i + 1) % n;
  }
  for (std::size_t i = 0; i < n; ++i) offer(i);
  for (std::size_t left = n; left > length;) {
    const Ear ear = ears.top();
    ears.pop();
    const std::size_t i = ear.corner;
    if (gone[i] || ear.version != version[i]) continue;
    triangles.push_back({loop[previous[i]], loop[i], loop[next[i]]});
    gone[i] = 1;
    --left;
    next[previous[i]] = next[i];
    previous[next[i]] = previous[i];
    offer(previous[i]);
    offer(next[i]);
  }
  std::vector<std::int32_t> rest;
  for (std::size_t i = 0; i < n; ++i)
    if (!gone[i]) rest.push_back(loop[i]);
  return rest;
}

}  // namespace

std::vector<std::vector<std::int32_t>> holeLoops(const TriangleMesh& mesh) {
  requireTriangles(mesh);
  const std::vector<DirectedEdge> missing = missingEdges(mesh);
  std::vector<char> walked(missing.size(), 0);
  // Index on the current walk: a point that is met again closes a loop.
  std::vector<std::int32_t> position(mesh.points.size(), -1);
  const auto nextFrom = [&](std::int32_t point) {
    auto e = std::lower_bound(missing.begin(), missing.end(), DirectedEdge{point, -1});
    while (e != missing.end() && e->from == point && walked[e - missing.begin()]) ++e;
    return e != missing.end() && e->from == point ? e - missing.begin() : std::ptrdiff_t(-1);
  };
  std::vector<std::vector<std::int32_t>> loops;
  std::vector<std::int32_t> walk;
  for (std::size_t seed = 0; seed < missing.size(); ++seed) {
    if (walked[seed]) continue;
    walk.assign(1, missing[seed].from);
    position[walk[0]] = 0;
    for (std::ptrdiff_t e = std::ptrdiff_t(seed); e >= 0; e = nextFrom(walk.back())) {
      walked[e] = 1;
      const std::int32_t to = missing[e].to;
      if (position[to] < 0) {
        position[to] = std::int32_t(walk.size());
        walk.push_back(to);
        continue;
      }
      std::vector<std::int32_t> loop(walk.begin() + position[to], walk.end());
      for (std::size_t i = 1; i < loop.size(); ++i) position[loop[i]] = -1;
      walk.resize(std::size_t(position[to]) + 1);
      loops.push_back(std::move(loop));
    }
    for (const std::int32_t p : walk) position[p] = -1;
  }
  return loops;
}

void fillHole(std::span<const Vec3> points, std::span<const std::int32_t> loop,
              std::vector<Triangle>& triangles) {
  if (loop.size() < 3) return;
  if (loop.size() <= kLongestExactLoop) return fillWithLeastArea(points, loop, triangles);
  fillWithLeastArea(points, shorten(points, loop, kLongestExactLoop, triangles), triangles);
}

}  // namespace resect
