#include "isosurface/relax.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/parallel.h"

namespace resect {
namespace {

constexpr std::size_t kRelaxGrain = 512;

// Exact for linear functions: four values at the corners of a regular tetrahedron.
Vec3 gradient(const ScalarFunction& value, const Vec3& p, double step) {
  Vec3 g = Vec3::Zero();
  for (const Vec3& d : {Vec3(1, 1, 1), Vec3(1, -1, -1), Vec3(-1, 1, -1), Vec3(-1, -1, 1)})
    g += d * value(p + step * d);
  return g / (4 * step);
}

using Edge = std::pair<std::int32_t, std::int32_t>;  // smaller index first

Edge edgeOf(const Triangle& t, int side) { return std::minmax({t[side], t[(side + 1) % 3]}); }

// The surface's intersection with the line from p along the unit direction `outwards`, at most
// `reach` away; p if there is none.
Vec3 onSurface(const ScalarFunction& value, const Vec3& p, const Vec3& outwards, double reach) {
  double near = 0, atNear = value(p);
  const double sign = atNear < 0 ? 1 : -1;
  double far = 0, atFar = atNear;
  for (double share : {0.125, 0.25, 0.5, 1.0}) {
    far = sign * share * reach;
    atFar = value(p + far * outwards);
    if ((atFar < 0) != (atNear < 0)) break;
    near = far;
  }
  if ((atFar < 0) == (atNear < 0)) return p;
  for (int step = 0; step < 12; ++step) {
    const double middle = 0.5 * (near + far);
    const double v = value(p + middle * outwards);
    ((v < 0) == (atNear < 0) ? near : far) = middle;
  }
  return p + 0.5 * (near + far) * outwards;
}

// Appends the parts of a triangle, of which some sides are split at a point (-1: none).
void addParts(const Triangle& t, const std::int32_t (&middle)[3], std::vector<Triangle>& out) {
  const int split = (middle[0] >= 0) + (middle[1] >= 0) + (middle[2] >= 0);
  if (split == 0) {
    out.push_back(t);
  } else if (split == 3) {
    out.push_back({t[0], middle[0], middle[2]});
    out.push_back({middle[0], t[1], middle[1]});
    out.push_back({middle[2], middle[1], t[2]});
    out.push_back({middle[0], middle[1], middle[2]});
  } else {
    // Rotated so that the first side is split and the last is not.
    int s = 0;
    while (middle[s] < 0 || middle[(s + 2) % 3] >= 0) ++s;
    const std::int32_t a = t[s], b = t[(s + 1) % 3], c = t[(s + 2) % 3];
    const std::int32_t ab = middle[s], bc = middle[(s + 1) % 3];
    if (split == 1) {
      out.push_back({a, ab, c});
      out.push_back({ab, b, c});
    } else {
      out.push_back({a, ab, c});
      out.push_back({ab, b, bc});
      out.push_back({ab, bc, c});
    }
  }
}

}  // namespace

void evenOut(const ScalarFunction& value, TriangleMesh& mesh, double edge) {
  std::vector<Vec3> sum(mesh.points.size(), Vec3::Zero());
  std::vector<int> count(mesh.points.size(), 0);
  for (const Triangle& t : mesh.triangles)
    for (int e = 0; e < 3; ++e) {
      sum[t[e]] += mesh.points[t[(e + 1) % 3]] + mesh.points[t[(e + 2) % 3]];
      count[t[e]] += 2;
    }
  parallelFor(mesh.points.size(), kRelaxGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Vec3 p = mesh.points[i];
      const Vec3 g = gradient(value, p, 0.02 * edge);
      const double slope = g.squaredNorm();
      if (count[i] == 0 || !(slope > 1e-6)) continue;
      const Vec3 pull = 0.5 * (sum[i] / count[i] - p);
      Vec3 moved = p + pull - g * (g.dot(pull) / slope);
      moved -= g * (value(moved) / slope);
      if ((moved - p).norm() > 0.5 * edge) continue;
      if (std::abs(value(moved)) > 0.02 * edge * std::sqrt(slope)) continue;
      mesh.points[i] = moved;
    }
  });
}

int splitCuttingEdges(const ScalarFunction& value, TriangleMesh& mesh, double tolerance) {
  std::vector<Edge> edges;
  edges.reserve(mesh.triangles.size() * 3);
  for (const Triangle& t : mesh.triangles)
    for (int side = 0; side < 3; ++side) edges.push_back(edgeOf(t, side));
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());

  // Area-weighted normals of the mesh: more stable than the gradient on a thin margin.
  std::vector<Vec3> normals(mesh.points.size(), Vec3::Zero());
  for (const Triangle& t : mesh.triangles) {
    const Vec3 n =
        (mesh.points[t[1]] - mesh.points[t[0]]).cross(mesh.points[t[2]] - mesh.points[t[0]]);
    for (std::int32_t corner : t) normals[corner] += n;
  }
  std::vector<Vec3> placed(edges.size());
  std::vector<char> cuts(edges.size(), 0);
  parallelFor(edges.size(), kRelaxGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto [a, b] = edges[i];
      const Vec3 middle = 0.5 * (mesh.points[a] + mesh.points[b]);
      const double length = (mesh.points[a] - mesh.points[b]).norm();
      // The value approximates the distance, so most edges need one evaluation only.
      if (std::abs(value(middle)) < 0.5 * tolerance * length) continue;
      const Vec3 mean = normals[a].normalized() + normals[b].normalized();
      if (!(mean.norm() > 1e-3)) continue;
      placed[i] = onSurface(value, middle, mean.normalized(), length);
      cuts[i] = (placed[i] - middle).norm() > tolerance * length;
    }
  });

  std::vector<std::int32_t> number(edges.size(), -1);
  int split = 0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (!cuts[i]) continue;
    number[i] = std::int32_t(mesh.points.size());
    mesh.points.push_back(placed[i]);
    ++split;
  }
  if (split == 0) return 0;
  std::vector<Triangle> triangles;
  triangles.reserve(mesh.triangles.size() + 2 * std::size_t(split));
  for (const Triangle& t : mesh.triangles) {
    std::int32_t middle[3];
    for (int side = 0; side < 3; ++side) {
      const auto at = std::lower_bound(edges.begin(), edges.end(), edgeOf(t, side));
      middle[side] = number[std::size_t(at - edges.begin())];
    }
    addParts(t, middle, triangles);
  }
  mesh.triangles = std::move(triangles);
  return split;
}

}  // namespace resect
