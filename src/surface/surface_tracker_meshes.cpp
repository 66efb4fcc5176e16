// Extracts meshes from the surface's arrays; updates are in surface_tracker.cpp, triangles of a
// brick in surface_tracker_triangles.cpp.
#include <algorithm>
#include <bit>
#include <cmath>

#include "surface/surface_tracker.h"

namespace resect {
namespace {

// Tests whether a rectangle in x and y holds a wanted column. Slightly enlarged, since columns and
// triangles are snapped to a raster before they are intersected.
class WantedColumns {
 public:
  WantedColumns(const ColumnGrid& grid, std::span<const std::uint8_t> wanted)
      : grid_(grid), wanted_(wanted) {}

  bool meet(const Vec2& low, const Vec2& high) const {
    constexpr double kMargin = 1e-4;  // of a pitch
    const Vec2 first = (low - grid_.origin).cwiseQuotient(grid_.pitch),
               last = (high - grid_.origin).cwiseQuotient(grid_.pitch);
    const int x0 = int(std::ceil(std::max(0.0, first.x() - kMargin)));
    const int y0 = int(std::ceil(std::max(0.0, first.y() - kMargin)));
    const int x1 = int(std::floor(std::min(grid_.countX - 1.0, last.x() + kMargin)));
    const int y1 = int(std::floor(std::min(grid_.countY - 1.0, last.y() + kMargin)));
    for (int y = y0; y <= y1; ++y)
      for (int x = x0; x <= x1; ++x)
        if (wanted_[std::size_t(y) * std::size_t(grid_.countX) + std::size_t(x)]) return true;
    return false;
  }

 private:
  const ColumnGrid& grid_;
  std::span<const std::uint8_t> wanted_;
};

}  // namespace

template <typename Visit>
void SurfaceTracker::visitVertices(Visit visit) const {
  for (const std::int32_t record : recordOf_) {
    const BrickMesh& mesh = bricks_[std::size_t(record)];
    const std::int32_t firstOfWound = mesh.firstVertex + mesh.signs.vertexCount();
    for (std::int32_t v = mesh.firstVertex; v < mesh.firstVertex + mesh.vertices; ++v)
      visit(std::size_t(v),
            v >= firstOfWound &&
                wounds_[std::size_t(mesh.wound)].vertices[std::size_t(v - firstOfWound)].twin);
  }
}

TriangleMesh SurfaceTracker::mesh(std::span<const Vec3f> points) const {
  TriangleMesh result;
  std::vector<std::int32_t> newIndex(points.size(), -1);
  visitVertices([&](std::size_t v, bool twin) {
    if (!twin) result.points.push_back(points[v].cast<double>());
    newIndex[v] = std::int32_t(result.points.size()) - 1;
  });
  result.triangles.reserve(std::size_t(triangleCount_));
  for (const std::int32_t record : recordOf_) {
    const BrickMesh& mesh = bricks_[std::size_t(record)];
    for (std::int32_t i = mesh.firstTriangle; i < mesh.firstTriangle + mesh.triangles; ++i) {
      const Triangle& t = triangles_[std::size_t(i)];
      result.triangles.push_back({newIndex[t[0]], newIndex[t[1]], newIndex[t[2]]});
    }
  }
  return result;
}

SurfaceTracker::Compact SurfaceTracker::compact(std::span<const Vec3f> points,
                                                std::span<const Vec3f> normals) const {
  Compact result{mesh(points), {}, {}};
  result.normals.reserve(result.mesh.points.size());
  result.cut.reserve(result.mesh.points.size());
  const std::span<const float> cutShares = cut();
  visitVertices([&](std::size_t v, bool twin) {
    if (twin) return;  // the same point of the mesh
    result.normals.push_back(normals[v]);
    result.cut.push_back(std::max(0.f, cutShares[v]));  // a rim is skin
  });
  return result;
}

std::vector<Vec3i> SurfaceTracker::anchorNodes(const ColourField& field) const {
  std::vector<Vec3i> nodes;
  for (std::int64_t b = 0; b < std::int64_t(recordOf_.size()); ++b) {
    if (!hasMesh(b)) continue;
    const BrickMesh& mesh = meshOf(b);
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

TriangleMesh SurfaceTracker::meshOver(const ColourField& field, const ColumnGrid& grid,
                                      std::span<const std::uint8_t> wanted) const {
  TriangleMesh mesh;
  const WantedColumns columns(grid, wanted);
  // Bricks over wanted columns; a brick's triangles lie between its first nodes and those of the
  // next brick.
  const auto brickAt = [&](const Vec2& p) {
    const Vec3 cell = field.lattice().toCellSpace({p.x(), p.y(), 0}) + Vec3::Constant(2);
    return Vec3(cell * field.refine() / kBrickNodes);
  };
  const Vec2 size = grid.pitch.cwiseProduct(Vec2(grid.countX - 1, grid.countY - 1));
  const Vec3 first = brickAt(grid.origin), last = brickAt(grid.origin + size);
  const Vec3i dims = field.brickDims();
  std::vector<Vec3i> over;
  for (int y = int(std::max(0.0, first.y() - 1)); y < std::min(double(dims.y()), last.y() + 1); ++y)
    for (int x = int(std::max(0.0, first.x() - 1)); x < std::min(double(dims.x()), last.x() + 1);
         ++x) {
      const Vec3 low = field.nodePosition(kBrickNodes * Vec3(x, y, 0));
      const Vec3 high = field.nodePosition(kBrickNodes * Vec3(x + 1, y + 1, 0));
      if (columns.meet(low.head<2>(), high.head<2>())) over.emplace_back(x, y, 0);
    }

  for (int z = 0; z < dims.z(); ++z)
    for (const Vec3i& b : over) {
      const BrickMesh& brick = meshOf(field.brickIndex({b.x(), b.y(), z}));
      for (int i = brick.firstTriangle; i < brick.firstTriangle + brick.triangles; ++i) {
        const Vec3f &p = points_[triangles_[i][0]], &q = points_[triangles_[i][1]],
                    &r = points_[triangles_[i][2]];
        const Vec3f low = p.cwiseMin(q).cwiseMin(r), high = p.cwiseMax(q).cwiseMax(r);
        if (!columns.meet(low.head<2>().cast<double>(), high.head<2>().cast<double>())) continue;
        const auto corner = std::int32_t(mesh.points.size());
        for (const Vec3f* v : {&p, &q, &r}) mesh.points.push_back(v->cast<double>());
        mesh.triangles.push_back({corner, corner + 1, corner + 2});
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
         (points_.capacity() + normals_.capacity()) * sizeof(Vec3f) + cut_.capacity() * 4 +
         edges_.capacity() + lookDue_.capacity() * 8 + triangles_.capacity() * sizeof(Triangle) +
         woundBytes;
}

}  // namespace resect
