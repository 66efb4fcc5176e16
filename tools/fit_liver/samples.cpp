#include "samples.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fit_liver {
namespace {

using resect::Aabb;
using resect::Random;
using resect::TriangleMesh;
using resect::Vec3;

constexpr double kMargin = 0.03;    // m around the liver
constexpr double kSharpest = 400;   // 1/m: bends beyond it are noise of the triangles
constexpr double kGentle = 0.012;   // m: a bend of this radius doubles the number of samples
constexpr double kPairGap = 0.004;  // m between the two points of a pair
constexpr double kNear = 0.005;     // m: standard deviation of the distance from the surface

Vec3 pointIn(const Aabb& box, Random& random) {
  return {random.uniform(box.min.x(), box.max.x()), random.uniform(box.min.y(), box.max.y()),
          random.uniform(box.min.z(), box.max.z())};
}

}  // namespace

double normal(Random& random) {
  return std::sqrt(-2 * std::log(1 - random.uniform())) *
         std::cos(2 * std::numbers::pi * random.uniform());
}

std::vector<SamplePair> samplesAround(const ReferenceSurface& reference, int even, int near,
                                      Random& random) {
  const TriangleMesh& mesh = reference.mesh();
  const Aabb box = resect::bounds(mesh).padded(kMargin);
  std::vector<double> area(mesh.triangles.size());
  std::vector<Vec3> normals(mesh.points.size(), Vec3::Zero());
  const auto cross = [&](const resect::Triangle& c) -> Vec3 {
    return (mesh.points[c[1]] - mesh.points[c[0]]).cross(mesh.points[c[2]] - mesh.points[c[0]]);
  };
  for (const auto& c : mesh.triangles)
    for (int corner : c) normals[corner] += cross(c);
  for (Vec3& n : normals) n.normalize();
  for (std::size_t t = 0; t < area.size(); ++t) {
    const auto& c = mesh.triangles[t];
    double bend = 0;  // 1/m
    for (int e = 0; e < 3; ++e) {
      const int a = c[e], b = c[(e + 1) % 3];
      bend = std::max(bend, (normals[a] - normals[b]).norm() /
                                std::max((mesh.points[a] - mesh.points[b]).norm(), 1e-4));
    }
    bend = std::min(bend, kSharpest) * kGentle;
    area[t] = 0.5 * cross(c).norm() * (1 + bend * bend) + (t ? area[t - 1] : 0);
  }
  std::vector<SamplePair> samples;
  const auto add = [&](const Vec3& p) {
    const Vec3 aside{normal(random), normal(random), normal(random)};
    const Vec3 q = p + kPairGap * aside.normalized();
    samples.push_back(
        {Sample{p, reference.signedDistance(p)}, Sample{q, reference.signedDistance(q)}});
  };
  for (int i = 0; i < even; ++i) add(pointIn(box, random));
  for (int i = 0; i < near; ++i) {
    const auto t =
        std::lower_bound(area.begin(), area.end(), random.uniform() * area.back()) - area.begin();
    const auto& c = mesh.triangles[std::min<std::size_t>(t, area.size() - 1)];
    double u = random.uniform(), v = random.uniform();
    if (u + v > 1) u = 1 - u, v = 1 - v;
    Vec3 p = mesh.points[c[0]] + u * (mesh.points[c[1]] - mesh.points[c[0]]) +
             v * (mesh.points[c[2]] - mesh.points[c[0]]);
    for (int m = 0; m < 3; ++m) p[m] += kNear * normal(random);
    add(p);
  }
  return samples;
}

}  // namespace fit_liver
