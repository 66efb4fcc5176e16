#include "surface/surface_tracker.h"

#include <algorithm>

#include "base/assert.h"
#include "base/parallel.h"
#include "surface/marching_cubes_table.h"

namespace resect {

SurfaceTracker::SurfaceTracker(const ColourField& field, float iso) : iso_(iso) {
  setIso(field, iso);
}

void SurfaceTracker::setIso(const ColourField& field, float iso) {
  RESECT_ASSERT(iso >= kMinIso && iso <= kMaxIso);
  iso_ = iso;
  clear(field);
  std::vector<std::int64_t> stored;
  for (std::int64_t b = 0; b < field.brickCount(); ++b)
    if (field.slot(b) >= 0) stored.push_back(b);
  remesh(field, stored);
  changes_.everything = true;
}

void SurfaceTracker::clear(const ColourField& field) {
  recordOf_.assign(std::size_t(field.brickCount()), kNone);
  bricks_.clear();
  freeRecords_.clear();
  vertexSpace_ = {};
  triangleSpace_ = {};
  points_.clear();
  normals_.clear();
  cut_.clear();
  triangles_.clear();
  triangleCount_ = 0;
}

void SurfaceTracker::update(const ColourField& field, std::span<const std::int64_t> touched) {
  remesh(field, touched);
}

void SurfaceTracker::dropRecord(std::int64_t brick) {
  std::int32_t& record = recordOf_[brick];
  if (record == kNone) return;
  BrickMesh& mesh = bricks_[record];
  if (mesh.vertices > 0) vertexSpace_.release(mesh.firstVertex, mesh.vertices);
  if (mesh.triangles > 0) {
    std::fill_n(triangles_.begin() + mesh.firstTriangle, mesh.triangles, Triangle{0, 0, 0});
    changes_.triangles.push_back({mesh.firstTriangle, mesh.triangles});
    triangleSpace_.release(mesh.firstTriangle, mesh.triangles);
    triangleCount_ -= mesh.triangles;
  }
  freeRecords_.push_back(record);
  record = kNone;
}

// `bricks`: ascending, each once.
void SurfaceTracker::remesh(const ColourField& field, std::span<const std::int64_t> bricks) {
  changes_.vertices.clear();
  changes_.triangles.clear();
  changes_.everything = false;
  changes_.bricks = std::int64_t(bricks.size());

  // 1. Which nodes are inside, which edges cross?
  newSigns_.assign(bricks.size(), {});
  parallelFor(bricks.size(), 32, [&](std::size_t begin, std::size_t end) {
    Halo halo;
    for (std::size_t i = begin; i < end; ++i) {
      if (field.slot(bricks[i]) < 0) continue;
      gatherHalo(field, field.brick(bricks[i]), halo);
      newSigns_[i] = brickSigns(halo, iso_);
    }
  });

  // 2. Give each brick room for its vertices; note whose triangles must be drawn again: its own and
  // those of the bricks
  //    below it that share its vertices.
  retriangulate_.clear();
  for (std::size_t i = 0; i < bricks.size(); ++i) {
    const std::int64_t b = bricks[i];
    const bool stored = field.slot(b) >= 0;
    const BrickSigns& signs = newSigns_[i];
    bool renumbered = stored != (recordOf_[b] != kNone);
    if (!stored) {
      dropRecord(b);
    } else {
      if (recordOf_[b] == kNone) {
        if (freeRecords_.empty()) {
          recordOf_[b] = std::int32_t(bricks_.size());
          bricks_.emplace_back();
        } else {
          recordOf_[b] = freeRecords_.back();
          freeRecords_.pop_back();
          bricks_[recordOf_[b]] = {};
        }
      }
      BrickMesh& mesh = bricks_[recordOf_[b]];
      renumbered = renumbered || !(mesh.signs == signs);
      const std::int32_t count = signs.vertexCount();
      if (RangeAllocator::roundedUp(count) != RangeAllocator::roundedUp(mesh.vertices)) {
        if (mesh.vertices > 0) vertexSpace_.release(mesh.firstVertex, mesh.vertices);
        mesh.firstVertex = count > 0 ? vertexSpace_.take(count) : 0;
      }
      mesh.vertices = count;
      mesh.signs = signs;
      if (count > 0) changes_.vertices.push_back({mesh.firstVertex, count});
    }
    if (!renumbered) continue;
    const Vec3i at = field.brick(b);
    for (int d = 0; d < 8; ++d) {
      const Vec3i n = at - Vec3i(d & 1, d >> 1 & 1, d >> 2 & 1);
      if ((n.array() >= 0).all()) retriangulate_.push_back(field.brickIndex(n));
    }
  }
  std::sort(retriangulate_.begin(), retriangulate_.end());
  retriangulate_.erase(std::unique(retriangulate_.begin(), retriangulate_.end()),
                       retriangulate_.end());

  // 3. Write the vertices.
  points_.resize(vertexSpace_.end(), Vec3f::Zero());
  normals_.resize(vertexSpace_.end(), Vec3f::UnitY());
  cut_.resize(vertexSpace_.end(), 0.f);
  parallelFor(bricks.size(), 32, [&](std::size_t begin, std::size_t end) {
    Halo halo;
    std::array<SurfaceVertex, 3 * kBrickSize> vertices;
    for (std::size_t i = begin; i < end; ++i) {
      const std::int64_t b = bricks[i];
      if (recordOf_[b] == kNone || bricks_[recordOf_[b]].vertices == 0) continue;
      const BrickMesh& mesh = bricks_[recordOf_[b]];
      const Vec3i at = field.brick(b);
      gatherHalo(field, at, halo);
      brickVertices(field, at, halo, mesh.signs, iso_, vertices.data());
      for (int v = 0; v < mesh.vertices; ++v) {
        points_[mesh.firstVertex + v] = vertices[v].position;
        normals_[mesh.firstVertex + v] = vertices[v].normal;
        cut_[mesh.firstVertex + v] = vertices[v].cut;
      }
    }
  });

  // 4. Draw the triangles.
  newTriangles_.assign(retriangulate_.size(), 0);
  parallelFor(retriangulate_.size(), 32, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      visitTriangles(field, retriangulate_[i], [&](const Triangle&) { ++newTriangles_[i]; });
  });
  for (std::size_t i = 0; i < retriangulate_.size(); ++i) {
    const std::int32_t record = recordOf_[retriangulate_[i]];
    if (record == kNone) {
      RESECT_ASSERT(newTriangles_[i] == 0);
      continue;
    }
    BrickMesh& mesh = bricks_[record];
    const std::int32_t count = newTriangles_[i];
    if (mesh.triangles > 0) changes_.triangles.push_back({mesh.firstTriangle, mesh.triangles});
    if (RangeAllocator::roundedUp(count) != RangeAllocator::roundedUp(mesh.triangles)) {
      if (mesh.triangles > 0) {
        std::fill_n(triangles_.begin() + mesh.firstTriangle, mesh.triangles, Triangle{0, 0, 0});
        triangleSpace_.release(mesh.firstTriangle, mesh.triangles);
      }
      mesh.firstTriangle = count > 0 ? triangleSpace_.take(count) : 0;
    } else if (mesh.triangles > count) {
      std::fill_n(triangles_.begin() + mesh.firstTriangle + count, mesh.triangles - count,
                  Triangle{0, 0, 0});
    }
    triangleCount_ += count - mesh.triangles;
    mesh.triangles = count;
    if (count > 0) changes_.triangles.push_back({mesh.firstTriangle, count});
  }
  triangles_.resize(triangleSpace_.end(), Triangle{0, 0, 0});
  parallelFor(retriangulate_.size(), 32, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (newTriangles_[i] == 0) continue;
      Triangle* out = triangles_.data() + bricks_[recordOf_[retriangulate_[i]]].firstTriangle;
      visitTriangles(field, retriangulate_[i], [&](const Triangle& t) { *out++ = t; });
    }
  });
}

// emit(triangle) for every triangle of the brick's 64 cells, in the order of the cells.
template <typename Emit>
void SurfaceTracker::visitTriangles(const ColourField& field, std::int64_t brick, Emit emit) const {
  if (recordOf_[brick] == kNone) return;
  // This brick and its seven neighbours above: their meshes (null where none) and inside masks.
  const BrickMesh* meshes[8];
  std::uint64_t inside[8];
  const Vec3i at = field.brick(brick);
  for (int d = 0; d < 8; ++d) {
    const Vec3i b = at + Vec3i(d & 1, d >> 1 & 1, d >> 2 & 1);
    const bool exists = (b.array() < field.brickDims().array()).all();
    const std::int64_t index = exists ? field.brickIndex(b) : -1;
    meshes[d] = exists && recordOf_[index] != kNone ? &bricks_[recordOf_[index]] : nullptr;
    inside[d] = meshes[d]                                           ? meshes[d]->signs.inside
                : exists && field.slot(index) == ColourField::kFull ? ~std::uint64_t(0)
                                                                    : 0;
  }
  // Does one of the 64 cells hold part of the surface at all?
  std::uint64_t any = 0, all = ~std::uint64_t(0);
  for (int d = 0; d < 8; ++d) any |= inside[d], all &= inside[d];
  if (any == 0 || all == ~std::uint64_t(0)) return;

  // Node (x, y, z), each 0 to 4, lies in neighbour d at bit n.
  const auto neighbour = [](int x, int y, int z) { return x >> 2 | (y >> 2) << 1 | (z >> 2) << 2; };
  const auto bit = [](int x, int y, int z) { return (x & 3) | (y & 3) << 2 | (z & 3) << 4; };
  std::uint8_t sign[5][5][5];
  for (int z = 0; z < 5; ++z)
    for (int y = 0; y < 5; ++y)
      for (int x = 0; x < 5; ++x) sign[z][y][x] = inside[neighbour(x, y, z)] >> bit(x, y, z) & 1;

  const auto& table = marchingCubesTable();
  for (int z = 0; z < 4; ++z)
    for (int y = 0; y < 4; ++y)
      for (int x = 0; x < 4; ++x) {
        int corners = 0;
        for (int c = 0; c < 8; ++c)
          corners |= sign[z + (c >> 2)][y + (c >> 1 & 1)][x + (c & 1)] << c;
        const CellTriangles& cell = table[corners];
        for (int t = 0; t < cell.count; ++t) {
          Triangle triangle;
          for (int v = 0; v < 3; ++v) {
            const CellEdge edge = kCellEdges[cell.edges[t][v]];
            const int nx = x + (edge.from & 1), ny = y + (edge.from >> 1 & 1),
                      nz = z + (edge.from >> 2);
            const BrickMesh* owner = meshes[neighbour(nx, ny, nz)];
            triangle[v] = owner->firstVertex + owner->signs.vertex(edge.axis, bit(nx, ny, nz));
          }
          emit(triangle);
        }
      }
}

SurfaceTracker::Compact SurfaceTracker::compact() const {
  Compact result;
  std::vector<std::int32_t> newIndex(points_.size(), -1);
  for (const std::int32_t record : recordOf_) {
    if (record == kNone) continue;
    const BrickMesh& mesh = bricks_[record];
    for (int v = mesh.firstVertex; v < mesh.firstVertex + mesh.vertices; ++v) {
      newIndex[v] = std::int32_t(result.mesh.points.size());
      result.mesh.points.push_back(points_[v].cast<double>());
      result.normals.push_back(normals_[v]);
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
  return recordOf_.capacity() * 4 + bricks_.capacity() * sizeof(BrickMesh) +
         points_.capacity() * 2 * sizeof(Vec3f) + cut_.capacity() * 4 +
         triangles_.capacity() * sizeof(Triangle);
}

}  // namespace resect
