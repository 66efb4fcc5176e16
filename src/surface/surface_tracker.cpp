#include "surface/surface_tracker.h"

#include <algorithm>

#include "base/assert.h"
#include "base/growth.h"
#include "base/parallel.h"

namespace resect {
namespace {

constexpr std::size_t kGrain = 128;     // bricks that one thread takes: some 50 us
constexpr std::size_t kWoundGrain = 8;  // the same of bricks that are cut

int trianglesIn(const std::array<std::uint64_t, 8>& corners, std::uint64_t cells) {
  return cells == 0 ? 0 : countTriangles(cellKinds(corners), cells);
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
  reserveFor(bricks_, stored.size() + kFirstOwn);
  changes_.everything = true;
  remesh(field, stored, wound);
}

void SurfaceTracker::clear(const ColourField& field) {
  recordOf_.resize(std::size_t(field.brickCount()));
  for (std::int64_t b = 0; b < field.brickCount(); ++b) recordOf_[b] = recordWithoutMesh(field, b);
  bricks_.assign(kFirstOwn, {});
  bricks_[kInside].signs.inside = ~std::uint64_t(0);
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
  changes_.everything = false;
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
  changes_.everything = false;
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

void SurfaceTracker::takeRecord(const ColourField& field, std::int64_t brick) {
  if (freeRecords_.empty()) {
    recordOf_[brick] = std::int32_t(bricks_.size());
    bricks_.emplace_back();
  } else {
    recordOf_[brick] = freeRecords_.back();
    freeRecords_.pop_back();
    meshOf(brick) = {};
  }
  const Vec3i at = field.brick(brick);
  for (int axis = 0; axis < 3; ++axis)
    meshOf(brick).last |= std::uint8_t((at[axis] + 1 == field.brickDims()[axis]) << axis);
}

void SurfaceTracker::dropRecord(std::int64_t brick) {
  if (!hasMesh(brick)) return;
  BrickMesh& mesh = meshOf(brick);
  if (mesh.vertices > 0) vertexSpace_.release(mesh.firstVertex, mesh.vertices);
  if (mesh.triangles > 0) {
    std::fill_n(triangles_.begin() + mesh.firstTriangle, mesh.triangles, Triangle{0, 0, 0});
    changes_.triangles.push_back({mesh.firstTriangle, mesh.triangles});
    triangleSpace_.release(mesh.firstTriangle, mesh.triangles);
    triangleCount_ -= mesh.triangles;
  }
  if (mesh.wound != kNone) freeWounds_.push_back(mesh.wound);
  freeRecords_.push_back(recordOf_[brick]);
}

// `bricks`: ascending, each once.
void SurfaceTracker::remesh(const ColourField& field, std::span<const std::int64_t> bricks,
                            const Wound* wound) {
  const auto nearWound = [&](std::int64_t b) { return wound && wound->severed.near(b); };
  changes_.vertices.clear();
  changes_.triangles.clear();
  const bool everything = changes_.everything;
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
    renumbered_[i] = stored != hasMesh(b);
    if (!stored) {
      dropRecord(b);
      recordOf_[b] = recordWithoutMesh(field, b);
      continue;
    }
    if (!hasMesh(b)) takeRecord(field, b);
    BrickSigns& signs = meshOf(b).signs;
    renumbered_[i] |= signs.inside != newInside_[i];
    signs.inside = newInside_[i];
    if (nearWound(b)) {
      takeWound(meshOf(b));
    }
  }

  // 2. Which edges cross the surface, and how many triangles do its cells hold? Then each brick
  // gets room for its vertices; its own triangles and those of the bricks below it, which share its
  // vertices, are drawn again.
  parallelFor(bricks.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (!hasMesh(bricks[i])) continue;
      const auto corners = cornerMasks(above(field, bricks[i]).inside);
      const std::array crossing = {corners[0] ^ corners[1], corners[0] ^ corners[2],
                                   corners[0] ^ corners[4]};
      BrickMesh& mesh = meshOf(bricks[i]);
      renumbered_[i] |= mesh.signs.crossing != crossing;
      mesh.signs.setCrossing(crossing);
      mesh.wholeTriangles = std::int16_t(trianglesIn(corners, crossedCells(corners)));
    }
  });
  woundBricks_.clear();
  if (wound)
    for (const std::int64_t b : bricks)
      if (meshOf(b).wound != kNone) woundBricks_.push_back(b);
  parallelFor(woundBricks_.size(), kWoundGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const BrickMesh& mesh = meshOf(woundBricks_[i]);
      makeBrickWound(field, *wound, field.brick(woundBricks_[i]), mesh.signs, iso_,
                     wounds_[std::size_t(mesh.wound)]);
    }
  });
  retriangulate_.clear();
  for (std::size_t i = 0; i < bricks.size(); ++i) {
    const std::int64_t b = bricks[i];
    bool drawOwn = false;
    if (hasMesh(b)) {
      BrickMesh& mesh = meshOf(b);
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
      if (count > 0 && !everything)
        changes_.vertices.push_back({mesh.firstVertex, RangeAllocator::roundedUp(count)});
      if (mesh.wound != kNone) {
        drawOwn = true;
        renumbered_[i] |= wounds_[std::size_t(mesh.wound)].renumbered;
      }
    }
    if (everything && hasMesh(b)) retriangulate_.push_back(b);
    if (everything || (!renumbered_[i] && !drawOwn)) continue;
    const Vec3i at = field.brick(b);
    for (int d = 0; d < (renumbered_[i] ? 8 : 1); ++d) {
      const Vec3i n = at - Vec3i(d & 1, d >> 1 & 1, d >> 2 & 1);
      if ((n.array() < 0).any()) continue;
      const std::int64_t below = field.brickIndex(n);
      if (!hasMesh(below) || meshOf(below).drawAgain) continue;
      meshOf(below).drawAgain = true;
      retriangulate_.push_back(below);
    }
  }

  // 3. Write the vertices.
  const auto vertexCount = std::size_t(vertexSpace_.end());
  growTo(points_, vertexCount);
  growTo(normals_, vertexCount);
  growTo(cut_, vertexCount);
  parallelFor(bricks.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::int64_t b = bricks[i];
      const BrickMesh& mesh = meshOf(b);
      if (mesh.vertices == 0) continue;
      std::int32_t at = mesh.firstVertex;
      if (mesh.signs.vertexCount() > 0)
        brickVertices(field, field.brick(b), mesh.signs, iso_, points_.data() + at,
                      normals_.data() + at, cut_.data() + at);
      at += mesh.signs.vertexCount();
      const auto write = [&](const SurfaceVertex& v) {
        points_[at] = v.position;
        normals_[at] = v.normal;
        cut_[at++] = v.cut;
      };
      if (mesh.wound != kNone)
        for (const BrickWound::Vertex& v : wounds_[std::size_t(mesh.wound)].vertices) write(v.at);
      const std::int32_t end = mesh.firstVertex + RangeAllocator::roundedUp(mesh.vertices);
      while (at < end) write({Vec3f::Zero(), Vec3f::UnitY(), 0});  // room to grow
    }
  });

  // 4. Draw the triangles.
  newTriangles_.assign(retriangulate_.size(), 0);
  parallelFor(retriangulate_.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const BrickMesh& mesh = meshOf(retriangulate_[i]);
      newTriangles_[i] = mesh.wholeTriangles;
      if (mesh.wound == kNone) continue;
      const BrickWound& cut = wounds_[std::size_t(mesh.wound)];
      const auto corners = cornerMasks(above(field, retriangulate_[i]).inside);
      newTriangles_[i] = trianglesIn(corners, crossedCells(corners) & ~cut.cells) +
                         std::int32_t(cut.triangles.size());
    }
  });
  for (std::size_t i = 0; i < retriangulate_.size(); ++i) {
    BrickMesh& mesh = meshOf(retriangulate_[i]);
    mesh.drawAgain = false;
    const std::int32_t count = newTriangles_[i];
    if (mesh.triangles > 0) changes_.triangles.push_back({mesh.firstTriangle, mesh.triangles});
    if (RangeAllocator::roundedUp(count) != RangeAllocator::roundedUp(mesh.triangles)) {
      if (mesh.triangles > 0) {
        std::fill_n(triangles_.begin() + mesh.firstTriangle, mesh.triangles, Triangle{0, 0, 0});
        triangleSpace_.release(mesh.firstTriangle, mesh.triangles);
      }
      mesh.firstTriangle = count > 0 ? triangleSpace_.take(count) : 0;
    }
    triangleCount_ += count - mesh.triangles;
    mesh.triangles = count;
    if (count > 0 && !everything) changes_.triangles.push_back({mesh.firstTriangle, count});
  }
  growTo(triangles_, std::size_t(triangleSpace_.end()));
  parallelFor(retriangulate_.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      if (meshOf(retriangulate_[i]).triangles > 0) drawTriangles(field, retriangulate_[i]);
  });
}

}  // namespace resect
