#include "isosurface/polygonise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "base/error.h"
#include "base/parallel.h"
#include "isosurface/relax.h"

namespace resect {
namespace {

using Value = ScalarFunction;
using Tetrahedron = std::array<std::int64_t, 4>;
using LatticeEdge = std::pair<std::int64_t, std::int64_t>;  // node inside, node outside

constexpr double kCellOfEdge =
    1.8;                  // side of a cube, in edges: triangles then have a mean edge of 0.77
constexpr int kLeaf = 4;  // cells a side of the smallest box that is skipped as a whole
constexpr std::size_t kGrain = 512;

// Nodes with an even number are corners of the cubes, those with an odd number centres.
class CubeLattice {
 public:
  CubeLattice(const Value& value, const Aabb& box, double cell)
      : value_(value), box_(box), cell_(cell), origin_(box.min - Vec3::Constant(1.5 * cell)) {
    for (int m = 0; m < 3; ++m) cells_[m] = int(std::ceil(box.size()[m] / cell)) + 3;
    nodes_ = cells_ + Vec3i::Ones();
    const std::size_t count = 2 * std::size_t(nodes_.x()) * nodes_.y() * nodes_.z();
    values_.assign(count, 0.0);
    wanted_.assign(count, 0);
  }

  Vec3i cells() const { return cells_; }
  double cell() const { return cell_; }
  std::int64_t node(const Vec3i& at, bool centre) const {
    return 2 * ((std::int64_t(at.x()) * nodes_.y() + at.y()) * nodes_.z() + at.z()) + centre;
  }
  Vec3 point(std::int64_t node) const {
    const std::int64_t n = node / 2;
    const Vec3i at(int(n / nodes_.z() / nodes_.y()), int(n / nodes_.z() % nodes_.y()),
                   int(n % nodes_.z()));
    return origin_ + cell_ * (at.cast<double>() + Vec3::Constant(node % 2 ? 0.5 : 0.0));
  }
  // The function clipped to the box, so that every surface is closed.
  double valueAt(const Vec3& p) const {
    const double beyond = (box_.min - p).cwiseMax(p - box_.max).maxCoeff();
    const double v = value_(p);
    return beyond > 0 ? std::max(beyond, v) : v;
  }
  void want(std::int64_t node) { wanted_[std::size_t(node)] = 1; }
  void evaluateWanted() {
    parallelFor(values_.size(), kGrain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n)
        if (wanted_[n]) values_[n] = valueAt(point(std::int64_t(n)));
    });
  }
  double value(std::int64_t node) const { return values_[std::size_t(node)]; }
  bool inside(std::int64_t node) const { return value(node) < 0; }

 private:
  const Value& value_;
  Aabb box_;
  double cell_;
  Vec3 origin_;
  Vec3i cells_, nodes_;
  std::vector<double> values_;
  std::vector<char> wanted_;
};

// Cubes [low, high).
struct CubeRange {
  Vec3i low, high;
};

// Halves the range until it is small or far from the surface.
void findNear(const CubeLattice& lattice, const CubeRange& range, double lipschitz,
              std::vector<CubeRange>& near) {
  const Vec3i size = range.high - range.low;
  if ((size.array() <= 0).any()) return;
  if (std::isfinite(lipschitz)) {
    // The tetrahedra extend one cube further on the high side.
    const Vec3 half = 0.5 * lattice.cell() * (size.cast<double>() + Vec3::Ones());
    const Vec3 middle = lattice.point(lattice.node(range.low, false)) + half;
    if (std::abs(lattice.valueAt(middle)) > std::max(lipschitz, 1.0) * half.norm()) return;
  }
  if (size.maxCoeff() <= kLeaf) {
    near.push_back(range);
    return;
  }
  int axis;
  size.maxCoeff(&axis);
  CubeRange a = range, b = range;
  a.high[axis] = b.low[axis] = range.low[axis] + size[axis] / 2;
  findNear(lattice, a, lipschitz, near);
  findNear(lattice, b, lipschitz, near);
}

// Calls visit with the twelve tetrahedra that each cube of the range owns: around the line from its
// centre to the next one along each axis. All have positive volume.
template <typename Visit>
void forTetrahedra(const CubeLattice& lattice, const CubeRange& range, const Visit& visit) {
  for (int i = range.low.x(); i < range.high.x(); ++i)
    for (int j = range.low.y(); j < range.high.y(); ++j)
      for (int k = range.low.z(); k < range.high.z(); ++k)
        for (int axis = 0; axis < 3; ++axis) {
          const Vec3i cube(i, j, k), u = Vec3i::Unit((axis + 1) % 3),
                                     v = Vec3i::Unit((axis + 2) % 3);
          const Vec3i next = cube + Vec3i::Unit(axis);
          const Vec3i ring[4] = {next, next + u, next + u + v, next + v};
          for (int side = 0; side < 4; ++side)
            visit(Tetrahedron{lattice.node(cube, true), lattice.node(next, true),
                              lattice.node(ring[side], false),
                              lattice.node(ring[(side + 1) % 4], false)});
        }
}

// Triangles over lattice edges; a point is one crossed edge.
class Crossings {
 public:
  explicit Crossings(const CubeLattice& lattice) : lattice_(lattice) {}

  void march(const Tetrahedron& t) {
    int inside = 0, first = -1, second = -1, outside = -1;
    for (int i = 0; i < 4; ++i) {
      if (!lattice_.inside(t[i])) {
        outside = i;
        continue;
      }
      if (inside == 0) first = i;
      if (inside == 1) second = i;
      ++inside;
    }
    if (inside == 1) {
      const Tetrahedron r = startingWith(t, first);
      triangles.push_back({point(r[0], r[1]), point(r[0], r[2]), point(r[0], r[3])});
    } else if (inside == 3) {
      const Tetrahedron r = startingWith(t, outside);
      triangles.push_back({point(r[1], r[0]), point(r[3], r[0]), point(r[2], r[0])});
    } else if (inside == 2) {
      Tetrahedron r = startingWith(t, first);
      while (r[1] != t[second]) r = {r[0], r[2], r[3], r[1]};
      const int a = point(r[0], r[2]), b = point(r[0], r[3]);
      const int c = point(r[1], r[3]), d = point(r[1], r[2]);
      triangles.push_back({a, b, c});
      triangles.push_back({a, c, d});
    }
  }

  std::vector<Triangle> triangles;
  std::vector<LatticeEdge> edges;

 private:
  // Even permutation of t that begins with t[i]: the volume keeps its sign.
  static Tetrahedron startingWith(const Tetrahedron& t, int i) {
    switch (i) {
      case 0:
        return t;
      case 1:
        return {t[1], t[0], t[3], t[2]};
      case 2:
        return {t[2], t[3], t[0], t[1]};
      default:
        return {t[3], t[2], t[1], t[0]};
    }
  }
  int point(std::int64_t inside, std::int64_t outside) {
    // The map is only looked up, never iterated: numbers follow the order of first use.
    const auto [at, fresh] = numbers_.try_emplace({inside, outside}, int(edges.size()));
    if (fresh) edges.emplace_back(inside, outside);
    return at->second;
  }
  struct Hash {
    std::size_t operator()(const LatticeEdge& e) const {
      std::uint64_t h = std::uint64_t(e.first) * 0x9e3779b97f4a7c15u + std::uint64_t(e.second);
      h ^= h >> 29;
      return std::size_t(h * 0xbf58476d1ce4e5b9u);
    }
  };

  const CubeLattice& lattice_;
  std::unordered_map<LatticeEdge, int, Hash> numbers_;
};

// The zero crossing on the edge: regula falsi, Illinois variant.
Vec3 crossing(const CubeLattice& lattice, const LatticeEdge& edge) {
  Vec3 a = lattice.point(edge.first), b = lattice.point(edge.second), p = b;
  double va = lattice.value(edge.first), vb = lattice.value(edge.second);
  int side = 0;
  const double close = 1e-4 * lattice.cell();
  for (int step = 0; step < 20 && vb > 0; ++step) {
    p = a + (b - a) * (va / (va - vb));
    const double v = lattice.valueAt(p);
    if (std::abs(v) < close) break;
    if (v < 0) {
      a = p, va = v;
      if (side == -1) vb *= 0.5;
      side = -1;
    } else {
      b = p, vb = v;
      if (side == 1) va *= 0.5;
      side = 1;
    }
  }
  return p;
}

}  // namespace

TriangleMesh polygonise(const Value& value, const Aabb& box, const PolygoniseSettings& settings) {
  require(settings.edge > 0 && settings.lipschitz > 0 && std::isfinite(settings.edge),
          "the longest edge is {} m, the function's greatest slope {}; give values above 0",
          settings.edge, settings.lipschitz);
  require(box.empty() || (box.min.allFinite() && box.max.allFinite()),
          "a surface was asked for in an endless box; give a finite one");
  TriangleMesh mesh;
  if (box.empty()) return mesh;
  CubeLattice lattice(value, box, kCellOfEdge * settings.edge);
  std::vector<CubeRange> near;
  findNear(lattice, {Vec3i::Zero(), lattice.cells() - Vec3i::Ones()}, settings.lipschitz, near);
  for (const CubeRange& range : near)
    forTetrahedra(lattice, range, [&](const Tetrahedron& t) {
      for (std::int64_t node : t) lattice.want(node);
    });
  lattice.evaluateWanted();

  Crossings crossings(lattice);
  for (const CubeRange& range : near)
    forTetrahedra(lattice, range, [&](const Tetrahedron& t) { crossings.march(t); });
  mesh.triangles = std::move(crossings.triangles);
  mesh.points.resize(crossings.edges.size());
  parallelFor(mesh.points.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      mesh.points[i] = crossing(lattice, crossings.edges[i]);
  });
  const Value cut = [&](const Vec3& p) { return lattice.valueAt(p); };
  for (int round = 0; round < settings.smoothing; ++round) {
    evenOut(cut, mesh, settings.edge);
    splitCuttingEdges(cut, mesh);
  }
  if (settings.smoothing > 0) evenOut(cut, mesh, settings.edge);
  return mesh;
}

}  // namespace resect
