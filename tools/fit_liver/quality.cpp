#include "quality.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/topology.h"
#include "isosurface/polygonise.h"

namespace fit_liver {

using resect::TriangleMesh;
using resect::Vec3;

Quality quality(std::span<const Part> parts, const ReferenceSurface& reference,
                std::span<const Sample> even) {
  const auto shape = shapeOf(parts);
  Quality q{};
  double both = 0, mine = 0, theirs = 0;
  for (const Sample& s : even) {
    const bool a = shape(s.point) < 0, b = s.distance < 0;
    both += a && b, mine += a, theirs += b;
  }
  q.dice = 2 * both / (mine + theirs);
  q.volumeRatio = mine / theirs;
  double area = 0;
  for (const resect::Triangle& c : reference.mesh().triangles) {
    const auto& points = reference.mesh().points;
    const Vec3 n = (points[c[1]] - points[c[0]]).cross(points[c[2]] - points[c[0]]);
    const Vec3 p = (points[c[0]] + points[c[1]] + points[c[2]]) / 3;
    Vec3 g;
    for (int m = 0; m < 3; ++m) {
      const Vec3 d = 1e-4 * Vec3::Unit(m);
      g[m] = shape(p + d) - shape(p - d);
    }
    const double a = n.norm();
    area += a;
    q.distance += a * std::abs(shape(p));
    const double angle = std::acos(std::clamp(n.dot(g) / (a * g.norm() + 1e-30), -1.0, 1.0));
    q.normalError += a * angle * angle;
  }
  q.distance /= area;
  q.normalError = 180 / std::numbers::pi * std::sqrt(q.normalError / area);
  const TriangleMesh mesh = resect::polygonise(shape, resect::bounds(reference.mesh()).padded(0.02),
                                               {.edge = 0.003, .smoothing = 0});
  const resect::Topology found = resect::topology(mesh);
  q.onePiece = found.components == 1 && mesh.points.size() * 2 == mesh.triangles.size() + 4;
  return q;
}

}  // namespace fit_liver
