#include "surface/surface_tracker.h"

#include <algorithm>
#include <bit>

#include "base/assert.h"
#include "base/parallel.h"
#include "surface/marching_cubes_table.h"

namespace resect {
namespace {

constexpr std::size_t kGrain = 128;  // bricks that one thread takes: some 50 us

// visit(cell, its triangles) for each of a brick's cells that the surface runs through, ascending;
// `inside`: as for cornerMasks().
template <typename Visit>
void visitCells(const std::array<std::uint64_t, 8>& inside, Visit visit) {
  const auto corners = cornerMasks(inside);
  std::uint64_t any = 0, all = ~std::uint64_t(0);
  for (const std::uint64_t mask : corners) any |= mask, all &= mask;
  const auto& table = marchingCubesTable();
  for (std::uint64_t rest = any & ~all; rest != 0; rest &= rest - 1) {
    const int cell = std::countr_zero(rest);
    int kind = 0;
    for (int c = 0; c < 8; ++c) kind |= int(corners[c] >> cell & 1) << c;
    visit(cell, table[kind]);
  }
}

}  // namespace

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

void SurfaceTracker::takeRecord(std::int64_t brick) {
  if (freeRecords_.empty()) {
    recordOf_[brick] = std::int32_t(bricks_.size());
    bricks_.emplace_back();
  } else {
    recordOf_[brick] = freeRecords_.back();
    freeRecords_.pop_back();
    bricks_[recordOf_[brick]] = {};
  }
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

  // 1. Which nodes are inside?
  newInside_.assign(bricks.size(), 0);
  parallelFor(bricks.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      if (const std::int32_t slot = field.slot(bricks[i]); slot >= 0)
        newInside_[i] = insideMask(field.values(slot), iso_);
  });
  renumbered_.assign(bricks.size(), 0);
  for (std::size_t i = 0; i < bricks.size(); ++i) {
    const std::int64_t b = bricks[i];
    const bool stored = field.slot(b) >= 0;
    renumbered_[i] = stored != (recordOf_[b] != kNone);
    if (!stored) {
      dropRecord(b);
      continue;
    }
    if (recordOf_[b] == kNone) takeRecord(b);
    BrickSigns& signs = bricks_[recordOf_[b]].signs;
    renumbered_[i] |= signs.inside != newInside_[i];
    signs.inside = newInside_[i];
  }

  // 2. Which edges cross the surface? Then each brick gets room for its vertices; its own triangles
  // and those of the bricks below it, which share its vertices, are drawn again.
  parallelFor(bricks.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (recordOf_[bricks[i]] == kNone) continue;
      const auto corners = cornerMasks(above(field, bricks[i]).inside);
      const std::array crossing = {corners[0] ^ corners[1], corners[0] ^ corners[2],
                                   corners[0] ^ corners[4]};
      BrickSigns& signs = bricks_[recordOf_[bricks[i]]].signs;
      renumbered_[i] |= signs.crossing != crossing;
      signs.setCrossing(crossing);
    }
  });
  retriangulate_.clear();
  for (std::size_t i = 0; i < bricks.size(); ++i) {
    const std::int64_t b = bricks[i];
    if (recordOf_[b] != kNone) {
      BrickMesh& mesh = bricks_[recordOf_[b]];
      const std::int32_t count = mesh.signs.vertexCount();
      if (RangeAllocator::roundedUp(count) != RangeAllocator::roundedUp(mesh.vertices)) {
        if (mesh.vertices > 0) vertexSpace_.release(mesh.firstVertex, mesh.vertices);
        mesh.firstVertex = count > 0 ? vertexSpace_.take(count) : 0;
      }
      mesh.vertices = count;
      if (count > 0) changes_.vertices.push_back({mesh.firstVertex, count});
    }
    if (!renumbered_[i]) continue;
    const Vec3i at = field.brick(b);
    for (int d = 0; d < 8; ++d) {
      const Vec3i n = at - Vec3i(d & 1, d >> 1 & 1, d >> 2 & 1);
      if ((n.array() < 0).any()) continue;
      const std::int64_t below = field.brickIndex(n);
      if (recordOf_[below] == kNone || bricks_[recordOf_[below]].drawAgain) continue;
      bricks_[recordOf_[below]].drawAgain = true;
      retriangulate_.push_back(below);
    }
  }

  // 3. Write the vertices.
  points_.resize(vertexSpace_.end(), Vec3f::Zero());
  normals_.resize(vertexSpace_.end(), Vec3f::UnitY());
  cut_.resize(vertexSpace_.end(), 0.f);
  parallelFor(bricks.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    std::array<SurfaceVertex, 3 * kBrickSize> vertices;
    for (std::size_t i = begin; i < end; ++i) {
      const std::int64_t b = bricks[i];
      if (recordOf_[b] == kNone || bricks_[recordOf_[b]].vertices == 0) continue;
      const BrickMesh& mesh = bricks_[recordOf_[b]];
      brickVertices(field, field.brick(b), mesh.signs, iso_, vertices.data());
      for (int v = 0; v < mesh.vertices; ++v) {
        points_[mesh.firstVertex + v] = vertices[v].position;
        normals_[mesh.firstVertex + v] = vertices[v].normal;
        cut_[mesh.firstVertex + v] = vertices[v].cut;
      }
    }
  });

  // 4. Draw the triangles.
  newTriangles_.assign(retriangulate_.size(), 0);
  parallelFor(retriangulate_.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      visitCells(above(field, retriangulate_[i]).inside,
                 [&](int, const CellTriangles& drawn) { newTriangles_[i] += drawn.count; });
  });
  for (std::size_t i = 0; i < retriangulate_.size(); ++i) {
    BrickMesh& mesh = bricks_[recordOf_[retriangulate_[i]]];
    mesh.drawAgain = false;
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
  parallelFor(retriangulate_.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      if (newTriangles_[i] > 0) drawTriangles(field, retriangulate_[i]);
  });
}

// The brick itself and its seven neighbours above, numbered as in cornerMasks(): their meshes, null
// where there is none.
SurfaceTracker::Above SurfaceTracker::above(const ColourField& field, std::int64_t brick) const {
  Above result{};
  const Vec3i at = field.brick(brick);
  for (int d = 0; d < 8; ++d) {
    const Vec3i b = at + Vec3i(d & 1, d >> 1 & 1, d >> 2 & 1);
    if ((b.array() >= field.brickDims().array()).any()) continue;
    const std::int64_t index = field.brickIndex(b);
    if (recordOf_[index] != kNone) {
      result.mesh[d] = &bricks_[recordOf_[index]];
      result.inside[d] = result.mesh[d]->signs.inside;
    } else if (field.slot(index) == ColourField::kFull) {
      result.inside[d] = ~std::uint64_t(0);
    }
  }
  return result;
}

void SurfaceTracker::drawTriangles(const ColourField& field, std::int64_t brick) {
  const Above around = above(field, brick);
  Triangle* out = triangles_.data() + bricks_[recordOf_[brick]].firstTriangle;
  visitCells(around.inside, [&](int cell, const CellTriangles& drawn) {
    for (int t = 0; t < drawn.count; ++t, ++out)
      for (int v = 0; v < 3; ++v) {
        const CellEdge edge = kCellEdges[drawn.edges[t][v]];
        // The edge's lower node, 0 to 4 along each axis: 4 lies in the neighbour above.
        const int x = (cell & 3) + (edge.from & 1), y = (cell >> 2 & 3) + (edge.from >> 1 & 1),
                  z = (cell >> 4) + (edge.from >> 2);
        const BrickMesh* owner = around.mesh[x >> 2 | (y >> 2) << 1 | (z >> 2) << 2];
        const int node = (x & 3) | (y & 3) << 2 | (z & 3) << 4;
        (*out)[v] = owner->firstVertex + owner->signs.vertex(edge.axis, node);
      }
  });
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
