#include "geometry/repair/mesh_health.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "geometry/measures.h"
#include "geometry/repair/crossings.h"

namespace resect {
namespace {

double ownVolume(const TriangleMesh& mesh) { return volumeAbout(mesh, bounds(mesh).centre()); }

bool isSpeck(double area, double volume) {
  // A ball of area A holds A^1.5 / (6 sqrt(pi)).
  constexpr double kLeastShareOfBall = 1e-6;
  const double ball = area * std::sqrt(area) / (6 * std::sqrt(std::numbers::pi));
  return std::abs(volume) <= kLeastShareOfBall * ball;
}

}  // namespace

bool isSpeck(const TriangleMesh& component) {
  return isSpeck(area(component), ownVolume(component));
}

std::vector<int> outermostOf(const std::vector<TriangleMesh>& components) {
  // Several points vote, since one may lie on the other's surface.
  constexpr std::size_t kVotes = 5;
  const int count = int(components.size());
  std::vector<int> outermost(count, -1), bySize(count);
  std::iota(bySize.begin(), bySize.end(), 0);
  std::vector<Aabb> boxes;
  std::vector<double> volumes;
  for (const TriangleMesh& c : components) {
    boxes.push_back(bounds(c));
    volumes.push_back(std::abs(ownVolume(c)));
  }
  std::stable_sort(bySize.begin(), bySize.end(),
                   [&](int a, int b) { return volumes[a] > volumes[b]; });
  // A surrounding body is larger, so the largest component that is in no other yet is outermost.
  std::vector<int> candidates;
  std::vector<Vec3> voters;
  for (std::size_t k = 0; k < bySize.size(); ++k) {
    const int outer = bySize[k];
    if (outermost[outer] >= 0) continue;
    outermost[outer] = outer;
    candidates.clear();
    voters.clear();
    for (std::size_t l = k + 1; l < bySize.size(); ++l) {
      const int inner = bySize[l];
      if (outermost[inner] >= 0 || !boxes[outer].contains(boxes[inner].min) ||
          !boxes[outer].contains(boxes[inner].max))
        continue;
      candidates.push_back(inner);
      const std::vector<Vec3>& points = components[inner].points;
      for (std::size_t v = 0; v < kVotes; ++v) voters.push_back(points[v * points.size() / kVotes]);
    }
    const std::vector<int> rounds = crossingNumbers(components[outer], voters);
    for (std::size_t c = 0; c < candidates.size(); ++c) {
      const auto first = rounds.begin() + std::ptrdiff_t(c * kVotes);
      const auto outside = std::size_t(std::count(first, first + kVotes, 0));
      if (2 * outside < kVotes) outermost[candidates[c]] = outer;
    }
  }
  return outermost;
}

MeshHealth examine(const TriangleMesh& mesh) { return examine(mesh, topology(mesh)); }

MeshHealth examine(const TriangleMesh& mesh, const Topology& t) {
  MeshHealth health;
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

  if (health.components == 1) {
    const double volume = volumeAbout(mesh, health.bounds.centre());
    health.specks = isSpeck(health.area, volume);
    health.insideOut = health.specks == 0 && volume < 0;
    return health;
  }
  std::vector<TriangleMesh> bodies = splitComponents(mesh);
  health.specks =
      int(std::erase_if(bodies, [](const TriangleMesh& body) { return isSpeck(body); }));
  const std::vector<int> outermost = outermostOf(bodies);
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (outermost[i] == int(i) && ownVolume(bodies[i]) < 0) health.insideOut = true;
  return health;
}

}  // namespace resect
