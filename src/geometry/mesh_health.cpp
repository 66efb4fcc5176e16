#include "geometry/mesh_health.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <numeric>

#include "geometry/measures.h"
#include "geometry/topology.h"

namespace resect {
namespace {

// Volume about the middle of the mesh: the same as about the origin for a closed mesh, but not
// drowned in rounding when it lies far away.
double ownVolume(const TriangleMesh& mesh) {
  const Vec3 origin = bounds(mesh).centre();
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    sum += (mesh.points[a] - origin).dot((mesh.points[b] - origin).cross(mesh.points[c] - origin));
  return sum / 6;
}

bool liesIn(const TriangleMesh& inner, const TriangleMesh& outer) {
  // Several points vote, since one may lie on the other's surface.
  constexpr std::size_t kVotes = 5;
  const std::size_t count = std::min(kVotes, inner.points.size());
  std::size_t inside = 0;
  for (std::size_t i = 0; i < count; ++i)
    if (std::abs(windingNumber(outer, inner.points[i * inner.points.size() / count])) > 0.5)
      ++inside;
  return 2 * inside > count;
}

}  // namespace

double windingNumber(const TriangleMesh& mesh, const Vec3& point) {
  double sum = 0;
  for (const auto& [i, j, k] : mesh.triangles) {
    const Vec3 a = mesh.points[i] - point, b = mesh.points[j] - point, c = mesh.points[k] - point;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    const double over = a.dot(b.cross(c));
    const double under = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
    sum += std::atan2(over, under);
  }
  return sum / (2 * std::numbers::pi);
}

bool isSpeck(const TriangleMesh& component) {
  // A ball of area A holds A^1.5 / (6 sqrt(pi)).
  constexpr double kLeastShareOfBall = 1e-6;
  const double ball = std::pow(area(component), 1.5) / (6 * std::sqrt(std::numbers::pi));
  return std::abs(ownVolume(component)) <= kLeastShareOfBall * ball;
}

std::vector<int> outermostOf(const std::vector<TriangleMesh>& components) {
  const int count = int(components.size());
  std::vector<int> outermost(count);
  std::iota(outermost.begin(), outermost.end(), 0);
  std::vector<Aabb> boxes;
  std::vector<double> volumes;
  for (const TriangleMesh& c : components) {
    boxes.push_back(bounds(c));
    volumes.push_back(std::abs(ownVolume(c)));
  }
  for (int i = 0; i < count; ++i)
    for (int j = 0; j < count; ++j) {
      // The largest body around i is its outermost one.
      if (i == j || volumes[j] <= volumes[outermost[i]]) continue;
      if (!boxes[j].contains(boxes[i].min) || !boxes[j].contains(boxes[i].max)) continue;
      if (liesIn(components[i], components[j])) outermost[i] = j;
    }
  return outermost;
}

MeshHealth examine(const TriangleMesh& mesh) {
  MeshHealth health;
  const Topology t = topology(mesh);
  health.triangles = int(mesh.triangles.size());
  health.points = int(mesh.points.size());
  health.area = area(mesh);
  health.volume = volume(mesh);
  health.bounds = bounds(mesh);
  health.components = t.components;
  health.closed = t.closed() && !mesh.triangles.empty();
  health.oriented = t.oriented() && !mesh.triangles.empty();
  health.boundaryEdges = t.boundaryEdges;
  health.nonManifoldEdges = t.nonManifoldEdges;
  health.firstBoundaryPoint = t.firstBoundaryPoint;
  if (!health.closed || !health.oriented) return health;

  const std::vector<TriangleMesh> pieces =
      t.components == 1 ? std::vector<TriangleMesh>{mesh} : splitComponents(mesh);
  std::vector<TriangleMesh> bodies;
  for (const TriangleMesh& piece : pieces)
    if (isSpeck(piece))
      ++health.specks;
    else
      bodies.push_back(piece);
  const std::vector<int> outermost = outermostOf(bodies);
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (outermost[i] == int(i) && ownVolume(bodies[i]) < 0) health.insideOut = true;
  return health;
}

}  // namespace resect
