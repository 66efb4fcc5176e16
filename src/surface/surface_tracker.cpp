#include "surface/surface_tracker.h"

#include <algorithm>
#include <bit>

#include "base/assert.h"
#include "base/growth.h"
#include "base/instruction_set.h"
#include "base/parallel.h"
#include "surface/marching_cubes_table.h"

namespace resect {
namespace {

constexpr std::size_t kGrain = 128;     // bricks that one thread takes: some 50 us
constexpr std::size_t kWoundGrain = 8;  // the same of bricks that are cut

// visit(cell, its triangles) for each of a brick's cells that the surface runs through, ascending,
// but those in `except`; `inside`: as for cornerMasks().
template <typename Visit>
[[gnu::always_inline]] inline void visitCells(const std::array<std::uint64_t, 8>& inside,
                                              std::uint64_t except, Visit visit) {
  const auto corners = cornerMasks(inside);
  std::uint64_t any = 0, all = ~std::uint64_t(0);
  for (const std::uint64_t mask : corners) any |= mask, all &= mask;
  const auto& table = marchingCubesTable();
  for (std::uint64_t rest = any & ~all & ~except; rest != 0; rest &= rest - 1) {
    const int cell = std::countr_zero(rest);
    int kind = 0;
    for (int c = 0; c < 8; ++c) kind |= int(corners[c] >> cell & 1) << c;
    visit(cell, table[kind]);
  }
}

RESECT_WIDEST
std::int32_t countTriangles(const std::array<std::uint64_t, 8>& inside, std::uint64_t except) {
  std::int32_t count = 0;
  visitCells(inside, except, [&](int, const CellTriangles& drawn) { count += drawn.count; });
  return count;
}

}  // namespace

SurfaceTracker::SurfaceTracker(const ColourField& field, float iso, const Wound* wound)
    : iso_(iso) {
  setIso(field, iso, wound);
}

void SurfaceTracker::setIso(const ColourField& field, float iso, const Wound* wound) {
  RESECT_ASSERT(iso >= kMinIso && iso <= kMaxIso);
  iso_ = iso;
  clear(field);
  std::vector<std::int64_t> stored;
  for (std::int64_t b = 0; b < field.brickCount(); ++b)
    if (field.slot(b) >= 0 || (wound && wound->severed.near(b))) stored.push_back(b);
  bricks_.reserve(stored.size());
  remesh(field, stored, wound);
  changes_.everything = true;
}

void SurfaceTracker::clear(const ColourField& field) {
  recordOf_.assign(std::size_t(field.brickCount()), kNone);
  bricks_.clear();
  freeRecords_.clear();
  wounds_.clear();
  freeWounds_.clear();
  vertexSpace_ = {};
  triangleSpace_ = {};
  points_.clear();
  normals_.clear();
  cut_.clear();
  triangles_.clear();
  triangleCount_ = 0;
}

void SurfaceTracker::update(const ColourField& field, std::span<const std::int64_t> touched) {
  remesh(field, touched, nullptr);
}

void SurfaceTracker::update(const ColourField& field, std::span<const std::int64_t> touched,
                            const Wound& wound, std::span<const TouchedBrick> severed) {
  withWound_.assign(touched.begin(), touched.end());
  for (const TouchedBrick& b : severed)
    if (b.within || looksFar(b.brick)) withWound_.push_back(b.brick);
  // At the skin the wound's rule looks two nodes round a cell: there a brick changes with those
  // beside it.
  if (!wound.severed.empty())
    for (const std::int64_t b : touched) {
      const Vec3i at = field.brick(b);
      const Vec3i low = (at - Vec3i::Ones()).cwiseMax(0);
      const Vec3i high = (at + Vec3i::Ones()).cwiseMin(field.brickDims() - Vec3i::Ones());
      for (int z = low.z(); z <= high.z(); ++z)
        for (int y = low.y(); y <= high.y(); ++y)
          for (int x = low.x(); x <= high.x(); ++x)
            if (const std::int64_t n = field.brickIndex({x, y, z});
                wound.severed.near(n) && looksFar(n))
              withWound_.push_back(n);
    }
  std::sort(withWound_.begin(), withWound_.end());
  withWound_.erase(std::unique(withWound_.begin(), withWound_.end()), withWound_.end());
  remesh(field, withWound_, &wound);
}

void SurfaceTracker::takeWound(BrickMesh& mesh) {
  if (mesh.wound != kNone) return;
  if (freeWounds_.empty()) {
    mesh.wound = std::int32_t(wounds_.size());
    wounds_.emplace_back();
  } else {
    mesh.wound = freeWounds_.back();
    freeWounds_.pop_back();
    wounds_[std::size_t(mesh.wound)] = {};
  }
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
  if (mesh.wound != kNone) freeWounds_.push_back(mesh.wound);
  freeRecords_.push_back(record);
  record = kNone;
}

// `bricks`: ascending, each once.
void SurfaceTracker::remesh(const ColourField& field, std::span<const std::int64_t> bricks,
                            const Wound* wound) {
  const auto nearWound = [&](std::int64_t b) { return wound && wound->severed.near(b); };
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
      else if (slot == ColourField::kFull)
        newInside_[i] = ~std::uint64_t(0);
  });
  renumbered_.assign(bricks.size(), 0);
  for (std::size_t i = 0; i < bricks.size(); ++i) {
    const std::int64_t b = bricks[i];
    const bool stored = field.slot(b) >= 0 || (field.slot(b) == ColourField::kFull && nearWound(b));
    renumbered_[i] = stored != (recordOf_[b] != kNone);
    if (!stored) {
      dropRecord(b);
      continue;
    }
    if (recordOf_[b] == kNone) takeRecord(b);
    BrickSigns& signs = bricks_[recordOf_[b]].signs;
    renumbered_[i] |= signs.inside != newInside_[i];
    signs.inside = newInside_[i];
    if (nearWound(b)) {
      takeWound(bricks_[recordOf_[b]]);
    }
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
  woundBricks_.clear();
  if (wound)
    for (const std::int64_t b : bricks)
      if (recordOf_[b] != kNone && bricks_[recordOf_[b]].wound != kNone) woundBricks_.push_back(b);
  parallelFor(woundBricks_.size(), kWoundGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const BrickMesh& mesh = bricks_[recordOf_[woundBricks_[i]]];
      makeBrickWound(field, *wound, field.brick(woundBricks_[i]), mesh.signs, iso_,
                     wounds_[std::size_t(mesh.wound)]);
    }
  });
  retriangulate_.clear();
  for (std::size_t i = 0; i < bricks.size(); ++i) {
    const std::int64_t b = bricks[i];
    bool drawOwn = false;
    if (recordOf_[b] != kNone) {
      BrickMesh& mesh = bricks_[recordOf_[b]];
      const std::int32_t count =
          mesh.signs.vertexCount() +
          (mesh.wound == kNone ? 0
                               : std::int32_t(wounds_[std::size_t(mesh.wound)].vertices.size()));
      if (RangeAllocator::roundedUp(count) != RangeAllocator::roundedUp(mesh.vertices)) {
        if (mesh.vertices > 0) vertexSpace_.release(mesh.firstVertex, mesh.vertices);
        mesh.firstVertex = count > 0 ? vertexSpace_.take(count) : 0;
        renumbered_[i] = true;
      }
      mesh.vertices = count;
      if (count > 0) changes_.vertices.push_back({mesh.firstVertex, count});
      if (mesh.wound != kNone) {
        drawOwn = true;
        renumbered_[i] |= wounds_[std::size_t(mesh.wound)].renumbered;
      }
    }
    if (!renumbered_[i] && !drawOwn) continue;
    const Vec3i at = field.brick(b);
    for (int d = 0; d < (renumbered_[i] ? 8 : 1); ++d) {
      const Vec3i n = at - Vec3i(d & 1, d >> 1 & 1, d >> 2 & 1);
      if ((n.array() < 0).any()) continue;
      const std::int64_t below = field.brickIndex(n);
      if (recordOf_[below] == kNone || bricks_[recordOf_[below]].drawAgain) continue;
      bricks_[recordOf_[below]].drawAgain = true;
      retriangulate_.push_back(below);
    }
  }

  // 3. Write the vertices.
  const auto vertexCount = std::size_t(vertexSpace_.end());
  growTo(points_, vertexCount, Vec3f(Vec3f::Zero()));
  growTo(normals_, vertexCount, Vec3f(Vec3f::UnitY()));
  growTo(cut_, vertexCount, 0.f);
  parallelFor(bricks.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    std::array<SurfaceVertex, 3 * kBrickSize> vertices;
    for (std::size_t i = begin; i < end; ++i) {
      const std::int64_t b = bricks[i];
      if (recordOf_[b] == kNone || bricks_[recordOf_[b]].vertices == 0) continue;
      const BrickMesh& mesh = bricks_[recordOf_[b]];
      if (mesh.signs.vertexCount() > 0)
        brickVertices(field, field.brick(b), mesh.signs, iso_, vertices.data());
      std::int32_t at = mesh.firstVertex;
      const auto write = [&](const SurfaceVertex& v) {
        points_[at] = v.position;
        normals_[at] = v.normal;
        cut_[at++] = v.cut;
      };
      for (int v = 0; v < mesh.signs.vertexCount(); ++v) write(vertices[v]);
      if (mesh.wound != kNone)
        for (const BrickWound::Vertex& v : wounds_[std::size_t(mesh.wound)].vertices) write(v.at);
    }
  });

  // 4. Draw the triangles.
  newTriangles_.assign(retriangulate_.size(), 0);
  parallelFor(retriangulate_.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const BrickMesh& mesh = bricks_[recordOf_[retriangulate_[i]]];
      newTriangles_[i] = countTriangles(above(field, retriangulate_[i]).inside, woundCells(mesh));
      if (mesh.wound != kNone)
        newTriangles_[i] += std::int32_t(wounds_[std::size_t(mesh.wound)].triangles.size());
    }
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
  growTo(triangles_, std::size_t(triangleSpace_.end()), Triangle{0, 0, 0});
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

RESECT_WIDEST
void SurfaceTracker::drawTriangles(const ColourField& field, std::int64_t brick) {
  const Above around = above(field, brick);
  const BrickMesh& mesh = bricks_[recordOf_[brick]];
  Triangle* out = triangles_.data() + mesh.firstTriangle;
  visitCells(around.inside, woundCells(mesh), [&](int cell, const CellTriangles& drawn) {
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
  if (mesh.wound != kNone) drawWound(around, wounds_[std::size_t(mesh.wound)], out);
}

// A wound's triangles name their corners by cell; here they get numbers.
void SurfaceTracker::drawWound(const Above& around, const BrickWound& wound, Triangle* out) const {
  const auto vertex = [&](const BrickWound::Triangle& t, int corner) {
    const Vec3i cell(t.cell & 3, t.cell >> 2 & 3, t.cell >> 4);
    // The brick, among those above, that owns what lies at a node, 0 to 4 along each axis.
    const auto owner = [&](const Vec3i& n) -> const BrickMesh& {
      return *around.mesh[n.x() >> 2 | (n.y() >> 2) << 1 | (n.z() >> 2) << 2];
    };
    const auto number = [](const Vec3i& n) {
      return (n.x() & 3) | (n.y() & 3) << 2 | (n.z() & 3) << 4;
    };
    const auto ofWound = [&](const BrickMesh& mesh) {
      return mesh.firstVertex + mesh.signs.vertexCount();
    };
    if (corner >= kFirstCellVertex) return ofWound(*around.mesh[0]) + corner - kFirstCellVertex;
    if (corner >= kFirstFaceVertex) {
      const int face = (corner - kFirstFaceVertex) / 8, axis = face / 2;
      const Vec3i n = cell + face % 2 * Vec3i::Unit(axis);
      const BrickMesh& mesh = owner(n);
      return ofWound(mesh) + wounds_[std::size_t(mesh.wound)].faceVertex(
                                 axis, number(n), (corner - kFirstFaceVertex) % 8, t.lip);
    }
    const CellEdge edge = kCellEdges[std::size_t(corner / 3)];
    const Vec3i n = cell + Vec3i(edge.from & 1, edge.from >> 1 & 1, edge.from >> 2);
    const BrickMesh& mesh = owner(n);
    if (corner % 3 == kIsoNode) return mesh.firstVertex + mesh.signs.vertex(edge.axis, number(n));
    return ofWound(mesh) +
           wounds_[std::size_t(mesh.wound)].edgeVertex(edge.axis, number(n), corner % 3);
  };
  for (const BrickWound::Triangle& t : wound.triangles)
    *out++ = {vertex(t, t.corners[0]), vertex(t, t.corners[1]), vertex(t, t.corners[2])};
}

}  // namespace resect
