// The surface as meshes of their own; following the organ is in surface_tracker.cpp.
#include <algorithm>
#include <bit>

#include "surface/surface_tracker.h"

namespace resect {

SurfaceTracker::Compact SurfaceTracker::compact(std::span<const Vec3f> points,
                                                std::span<const Vec3f> normals) const {
  Compact result;
  std::vector<std::int32_t> newIndex(points.size(), -1);
  for (const std::int32_t record : recordOf_) {
    if (record == kNone) continue;
    const BrickMesh& mesh = bricks_[record];
    const std::int32_t firstOfWound = mesh.firstVertex + mesh.signs.vertexCount();
    for (int v = mesh.firstVertex; v < mesh.firstVertex + mesh.vertices; ++v) {
      if (v >= firstOfWound &&
          wounds_[std::size_t(mesh.wound)].vertices[std::size_t(v - firstOfWound)].twin) {
        newIndex[v] = newIndex[v - 1];  // one point of the body's skin
        continue;
      }
      newIndex[v] = std::int32_t(result.mesh.points.size());
      result.mesh.points.push_back(points[v].cast<double>());
      result.normals.push_back(normals[v]);
      result.cut.push_back(cut_[v]);
    }
  }
  result.mesh.triangles.reserve(std::size_t(triangleCount_));
  for (const std::int32_t record : recordOf_) {
    if (record == kNone) continue;
    const BrickMesh& mesh = bricks_[record];
    for (int i = mesh.firstTriangle; i < mesh.firstTriangle + mesh.triangles; ++i) {
      const Triangle& t = triangles_[i];
      result.mesh.triangles.push_back({newIndex[t[0]], newIndex[t[1]], newIndex[t[2]]});
    }
  }
  return result;
}

std::vector<Vec3i> SurfaceTracker::anchorNodes(const ColourField& field) const {
  std::vector<Vec3i> nodes;
  for (std::int64_t b = 0; b < std::int64_t(recordOf_.size()); ++b) {
    if (recordOf_[b] == kNone) continue;
    const BrickMesh& mesh = bricks_[recordOf_[b]];
    const Vec3i first = kBrickNodes * field.brick(b);
    if (mesh.wound != kNone) {
      const BrickWound& wound = wounds_[std::size_t(mesh.wound)];
      const std::size_t before = wound.anchors.size() - wound.vertices.size();
      for (std::size_t v = 0; v < wound.anchors.size(); ++v)
        if (v < before || !wound.vertices[v - before].twin)
          nodes.push_back(first +
                          Vec3i(wound.anchors[v][0], wound.anchors[v][1], wound.anchors[v][2]));
      continue;
    }
    for (int axis = 0; axis < 3; ++axis)
      for (std::uint64_t rest = mesh.signs.crossing[axis]; rest != 0; rest &= rest - 1) {
        const int node = std::countr_zero(rest);
        const bool inside = mesh.signs.inside >> node & 1;
        nodes.push_back(first + Vec3i(node & 3, node >> 2 & 3, node >> 4) +
                        (inside ? Vec3i(Vec3i::Zero()) : Vec3i(Vec3i::Unit(axis))));
      }
  }
  return nodes;
}

TriangleMesh SurfaceTracker::meshAround(const ColourField& field, const Aabb& box) const {
  TriangleMesh mesh;
  if (box.empty()) return mesh;
  // Bricks whose cells can reach into the box in x and y; all of them in z.
  Vec3i low = Vec3i::Zero(), high = field.brickDims() - Vec3i::Ones();
  const auto brickAt = [&](const Vec3& p) {
    return Vec3((field.lattice().toCellSpace(p) + Vec3::Constant(2)) * field.refine() /
                kBrickNodes);
  };
  const Vec3 first = brickAt(box.min), last = brickAt(box.max);
  for (int a = 0; a < 2; ++a) {
    low[a] = std::max(low[a], int(std::floor(std::max(-1.0, first[a]))) - 1);
    high[a] = int(std::min(double(high[a]), std::floor(last[a])));
  }
  for (int z = low.z(); z <= high.z(); ++z)
    for (int y = low.y(); y <= high.y(); ++y)
      for (int x = low.x(); x <= high.x(); ++x) {
        const std::int32_t record = recordOf_[field.brickIndex({x, y, z})];
        if (record == kNone) continue;
        const BrickMesh& brick = bricks_[record];
        for (int i = brick.firstTriangle; i < brick.firstTriangle + brick.triangles; ++i) {
          const auto first = std::int32_t(mesh.points.size());
          for (const std::int32_t v : triangles_[i])
            mesh.points.push_back(points_[v].cast<double>());
          mesh.triangles.push_back({first, first + 1, first + 2});
        }
      }
  return mesh;
}

std::size_t SurfaceTracker::bytes() const {
  std::size_t woundBytes = wounds_.capacity() * sizeof(BrickWound);
  for (const BrickWound& w : wounds_)
    woundBytes += w.vertices.capacity() * sizeof(BrickWound::Vertex) +
                  w.triangles.capacity() * sizeof(BrickWound::Triangle) +
                  w.bindings.capacity() * sizeof(VertexBinding);
  return recordOf_.capacity() * 4 + bricks_.capacity() * sizeof(BrickMesh) +
         points_.capacity() * 2 * sizeof(Vec3f) + cut_.capacity() * 4 +
         triangles_.capacity() * sizeof(Triangle) + woundBytes;
}

}  // namespace resect
