#include "geometry/repair/repair.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "geometry/measures.h"
#include "geometry/repair/hole.h"
#include "geometry/repair/mesh_health.h"
#include "geometry/topology.h"

namespace resect {
namespace {

struct EdgeUse {
  std::uint64_t edge;  // smaller point index << 32 | larger
  std::int32_t triangle;
  bool forward;  // from the smaller to the larger point
};

std::vector<EdgeUse> sortedEdgeUses(const TriangleMesh& mesh) {
  std::vector<EdgeUse> uses;
  uses.reserve(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int i = 0; i < 3; ++i) {
      const auto a = std::uint64_t(mesh.triangles[t][i]);
      const auto b = std::uint64_t(mesh.triangles[t][(i + 1) % 3]);
      uses.push_back({std::min(a, b) << 32 | std::max(a, b), std::int32_t(t), a < b});
    }
  std::sort(uses.begin(), uses.end(), [](const EdgeUse& a, const EdgeUse& b) {
    return a.edge != b.edge ? a.edge < b.edge : a.triangle < b.triangle;
  });
  return uses;
}

// One use of each edge that an odd number of triangles has.
std::vector<EdgeUse> oddEdges(const TriangleMesh& mesh) {
  const std::vector<EdgeUse> uses = sortedEdgeUses(mesh);
  std::vector<EdgeUse> odd;
  for (std::size_t i = 0, next = 0; i < uses.size(); i = next) {
    for (next = i + 1; next < uses.size() && uses[next].edge == uses[i].edge;) ++next;
    if ((next - i) % 2 == 1) odd.push_back(uses[i]);
  }
  return odd;
}

// The mesh without the triangles of the components marked in `drop`, unused points left out.
TriangleMesh without(const TriangleMesh& mesh, const std::vector<std::int32_t>& component,
                     const std::vector<char>& drop) {
  TriangleMesh kept;
  std::vector<std::int32_t> newIndex(mesh.points.size(), -1);
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    if (component[i] >= 0 && !drop[component[i]]) {
      newIndex[i] = std::int32_t(kept.points.size());
      kept.points.push_back(mesh.points[i]);
    }
  for (const Triangle& t : mesh.triangles)
    if (!drop[component[t[0]]])
      kept.triangles.push_back({newIndex[t[0]], newIndex[t[1]], newIndex[t[2]]});
  return kept;
}

}  // namespace

void orientConsistently(TriangleMesh& mesh, RepairReport& report) {
  requireTriangles(mesh);
  // Neighbours over edges of exactly two triangles; at such an edge "same direction" means that one
  // of the two must be flipped.
  struct Neighbour {
    std::int32_t triangle;
    bool turned;
  };
  const std::vector<EdgeUse> uses = sortedEdgeUses(mesh);
  std::vector<std::array<Neighbour, 3>> neighbours(mesh.triangles.size());
  std::vector<int> degree(mesh.triangles.size(), 0);
  for (std::size_t first = 0; first < uses.size();) {
    std::size_t last = first;
    while (last < uses.size() && uses[last].edge == uses[first].edge) ++last;
    if (last - first == 2) {
      const EdgeUse &a = uses[first], &b = uses[first + 1];
      if (a.triangle != b.triangle) {
        const bool turned = a.forward == b.forward;
        neighbours[a.triangle][degree[a.triangle]++] = {b.triangle, turned};
        neighbours[b.triangle][degree[b.triangle]++] = {a.triangle, turned};
      }
    }
    first = last;
  }

  std::vector<char> seen(mesh.triangles.size(), 0), turn(mesh.triangles.size(), 0);
  std::vector<std::int32_t> patch;
  for (std::size_t seed = 0; seed < mesh.triangles.size(); ++seed) {
    if (seen[seed]) continue;
    patch.assign(1, std::int32_t(seed));
    seen[seed] = 1;
    std::size_t turned = 0;
    for (std::size_t next = 0; next < patch.size(); ++next) {
      const std::int32_t t = patch[next];
      turned += turn[t];
      for (int i = 0; i < degree[t]; ++i) {
        const Neighbour& n = neighbours[t][i];
        if (seen[n.triangle]) continue;
        seen[n.triangle] = 1;
        turn[n.triangle] = char(turn[t] ^ char(n.turned));
        patch.push_back(n.triangle);
      }
    }
    const bool invert = 2 * turned > patch.size();
    for (const std::int32_t t : patch)
      if (bool(turn[t]) != invert) {
        std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
        ++report.trianglesTurned;
      }
  }
}

void closeHoles(TriangleMesh& mesh, RepairReport& report) {
  const Vec3 middle = bounds(mesh).centre();
  report.volumeBefore = volumeAbout(mesh, middle);
  const std::size_t before = mesh.triangles.size();
  for (const std::vector<std::int32_t>& loop : holeLoops(mesh)) {
    fillHole(mesh.points, loop, mesh.triangles);
    ++report.holesClosed;
  }
  report.trianglesAdded += int(mesh.triangles.size() - before);
  for (std::size_t i = before; i < mesh.triangles.size(); ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    report.areaAdded +=
        0.5 * (mesh.points[b] - mesh.points[a]).cross(mesh.points[c] - mesh.points[a]).norm();
  }
  report.volumeAfter = volumeAbout(mesh, middle);
}

void dropDoubled(TriangleMesh& mesh, RepairReport& report) {
  requireTriangles(mesh);
  // Triangles of the same corners, in the order of the mesh, lie one after the other.
  std::vector<std::pair<Triangle, std::int32_t>> byCorners;
  byCorners.reserve(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    Triangle corners = mesh.triangles[t];
    std::sort(corners.begin(), corners.end());
    byCorners.emplace_back(corners, std::int32_t(t));
  }
  std::sort(byCorners.begin(), byCorners.end());
  int components = 0;
  const std::vector<std::int32_t> component = pointComponents(mesh, &components);
  std::vector<char> isFirst(mesh.triangles.size(), 0), allDoubled(std::size_t(components), 1);
  for (std::size_t i = 0, next = 0; i < byCorners.size(); i = next) {
    for (next = i + 1; next < byCorners.size() && byCorners[next].first == byCorners[i].first;)
      ++next;
    isFirst[std::size_t(byCorners[i].second)] = 1;
    if (next == i + 1) allDoubled[std::size_t(component[byCorners[i].first[0]])] = 0;
  }
  if (std::ranges::count(allDoubled, 1) == 0) return;
  TriangleMesh once;  // the first triangles of the components in question
  once.points = mesh.points;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (isFirst[t] && allDoubled[std::size_t(component[mesh.triangles[t][0]])])
      once.triangles.push_back(mesh.triangles[t]);
  for (const EdgeUse& use : oddEdges(once))
    allDoubled[std::size_t(component[std::int32_t(use.edge >> 32)])] = 0;
  std::vector<Triangle> kept;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (isFirst[t] || !allDoubled[std::size_t(component[mesh.triangles[t][0]])])
      kept.push_back(mesh.triangles[t]);
  report.trianglesDoubled += int(mesh.triangles.size() - kept.size());
  mesh.triangles = std::move(kept);
}

void dropSpecks(TriangleMesh& mesh, RepairReport& report) {
  const std::vector<TriangleMesh> pieces = splitComponents(mesh);
  std::vector<char> drop(pieces.size(), 0);
  int specks = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) specks += drop[i] = isSpeck(pieces[i]);
  if (specks == 0) return;
  report.specksDropped += specks;
  mesh = without(mesh, pointComponents(mesh), drop);
}

void turnOutwards(TriangleMesh& mesh, RepairReport& report) {
  const std::vector<std::int32_t> component = pointComponents(mesh);
  const std::vector<TriangleMesh> pieces = splitComponents(mesh);
  const std::vector<int> outermost = outermostOf(pieces);
  std::vector<char> inward(pieces.size(), 0);
  for (std::size_t i = 0; i < pieces.size(); ++i)
    inward[i] = volumeAbout(pieces[i], bounds(pieces[i]).centre()) < 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) report.componentsTurned += inward[outermost[i]];
  for (Triangle& t : mesh.triangles)
    if (inward[outermost[component[t[0]]]]) std::swap(t[1], t[2]);
}

}  // namespace resect
