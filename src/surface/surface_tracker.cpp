#include "surface/surface_tracker.h"

#include <algorithm>

#include "base/error.h"
#include "base/growth.h"
#include "base/instruction_set.h"
#include "base/parallel.h"

namespace resect {
namespace {

constexpr std::size_t kGrain = 128;     // bricks per block of work: some 50 us
constexpr std::size_t kWoundGrain = 8;  // the same for bricks with cuts

RESECT_WIDEST
void insideMasks(const ColourField& field, std::span<const std::int64_t> bricks, float iso,
                 std::uint64_t* masks) {
  for (const std::int64_t b : bricks) {
    const std::int32_t slot = field.slot(b);
    *masks++ = slot >= 0                    ? insideMask(field.values(slot), iso)
               : slot == ColourField::kFull ? ~std::uint64_t(0)
                                            : 0;
  }
}

}  // namespace

SurfaceTracker::SurfaceTracker(const ColourField& field, float iso, const Wound* wound)
    : iso_(iso) {
  setIso(field, iso, wound);
}

void SurfaceTracker::setIso(const ColourField& field, float iso, const Wound* wound) {
  requireIso(iso);
  iso_ = iso;
  meshAll(field, nullptr, wound);
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
  // At the organ's surface the wound's rules use two nodes round a cell: there a brick changes with
  // its neighbours.
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

void SurfaceTracker::updateRestored(const ColourField& field, std::span<const std::int64_t> touched,
                                    const Wound* wound) {
  withWound_.assign(touched.begin(), touched.end());
  for (std::int64_t b = 0; b < field.brickCount(); ++b)
    if (meshOf(b).wound != kNone || (wound && wound->severed.near(b))) withWound_.push_back(b);
  std::sort(withWound_.begin(), withWound_.end());
  withWound_.erase(std::unique(withWound_.begin(), withWound_.end()), withWound_.end());
  changes_.everything = false;
  remesh(field, withWound_, wound);
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

void SurfaceTracker::dropWound(BrickMesh& mesh) {
  if (mesh.wound == kNone) return;
  freeWounds_.push_back(mesh.wound);
  mesh.wound = kNone;
}

void SurfaceTracker::takeRecord(std::int64_t brick) {
  if (freeRecords_.empty()) {
    recordOf_[brick] = std::int32_t(bricks_.size());
    bricks_.emplace_back();
  } else {
    recordOf_[brick] = freeRecords_.back();
    freeRecords_.pop_back();
    meshOf(brick) = {};
  }
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
  dropWound(mesh);
  freeRecords_.push_back(recordOf_[brick]);
}

// `bricks`: ascending, each once.
void SurfaceTracker::remesh(const ColourField& field, std::span<const std::int64_t> bricks,
                            const Wound* wound) {
  ++changes_.number;
  changes_.vertices.clear();
  changes_.triangles.clear();
  changes_.bricks = std::int64_t(bricks.size());
  findInside(field, bricks, wound);
  findCrossings(field, bricks);
  if (wound) {
    woundBricks_.clear();
    for (const std::int64_t b : bricks)
      if (meshOf(b).wound != kNone) woundBricks_.push_back(b);
    meshWounds(field, *wound);
  }
  placeVertices(field, bricks);
  lookIsDue(bricks);
  const NodeGrid grid(field, iso_);
  parallelFor(bricks.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) writeVertices(field, grid, bricks[i]);
  });
  placeTriangles(field);
  parallelFor(retriangulate_.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      if (meshOf(retriangulate_[i]).triangles > 0) drawTriangles(field, retriangulate_[i]);
  });
}

// Finds which bricks hold a mesh and which of their nodes are inside. Marks those that changed.
void SurfaceTracker::findInside(const ColourField& field, std::span<const std::int64_t> bricks,
                                const Wound* wound) {
  newInside_.resize(bricks.size());
  parallelFor(bricks.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    insideMasks(field, bricks.subspan(begin, end - begin), iso_, newInside_.data() + begin);
  });
  renumbered_.assign(bricks.size(), 0);
  for (std::size_t i = 0; i < bricks.size(); ++i) {
    const std::int64_t b = bricks[i];
    const bool cut = wound && wound->severed.near(b);
    const bool stored = field.slot(b) >= 0 || (field.slot(b) == ColourField::kFull && cut);
    renumbered_[i] = stored != hasMesh(b);
    if (!stored) {
      dropRecord(b);
      recordOf_[b] = recordWithoutMesh(field.slot(b));
      continue;
    }
    if (!hasMesh(b)) takeRecord(b);
    BrickMesh& mesh = meshOf(b);
    renumbered_[i] |= mesh.signs.inside != newInside_[i];
    mesh.signs.inside = newInside_[i];
    renumbered_[i] |= !cut && mesh.wound != kNone;
    cut ? takeWound(mesh) : dropWound(mesh);
  }
}

// Finds the crossed edges and the number of triangles of the bricks' cells. Marks bricks where
// these changed.
void SurfaceTracker::findCrossings(const ColourField& field, std::span<const std::int64_t> bricks) {
  parallelFor(bricks.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      if (hasMesh(bricks[i])) renumbered_[i] |= findCrossings(field, bricks[i]);
  });
}

// Meshes the wounds of woundBricks_.
void SurfaceTracker::meshWounds(const ColourField& field, const Wound& wound) {
  parallelFor(woundBricks_.size(), kWoundGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const BrickMesh& mesh = meshOf(woundBricks_[i]);
      makeBrickWound(field, wound, field.brick(woundBricks_[i]), mesh.signs, iso_,
                     wounds_[std::size_t(mesh.wound)]);
    }
  });
}

// Allocates each brick's vertices. If their indices change, the triangles of the brick and of the
// bricks below, which share its vertices, are written again.
void SurfaceTracker::placeVertices(const ColourField& field, std::span<const std::int64_t> bricks) {
  retriangulate_.clear();
  for (std::size_t i = 0; i < bricks.size(); ++i) {
    const std::int64_t b = bricks[i];
    bool drawOwn = false;
    if (hasMesh(b)) {
      BrickMesh& mesh = meshOf(b);
      const BrickWound* wound = mesh.wound == kNone ? nullptr : &wounds_[std::size_t(mesh.wound)];
      const std::int32_t count = vertexCountOf(mesh);
      if (RangeAllocator::roundedUp(count) != RangeAllocator::roundedUp(mesh.vertices)) {
        if (mesh.vertices > 0) vertexSpace_.release(mesh.firstVertex, mesh.vertices);
        mesh.firstVertex = count > 0 ? vertexSpace_.take(count) : 0;
        renumbered_[i] = true;
      }
      mesh.vertices = count;
      if (count > 0)
        changes_.vertices.push_back({mesh.firstVertex, RangeAllocator::roundedUp(count)});
      if (wound) {
        drawOwn = true;
        renumbered_[i] |= wound->renumbered;
      }
    }
    if (!renumbered_[i] && !drawOwn) continue;
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
  const auto vertexCount = std::size_t(vertexSpace_.end());
  growTo(points_, vertexCount);
  growTo(edges_, vertexCount);
}

void SurfaceTracker::writeVertices(const ColourField& field, const NodeGrid& grid,
                                   std::int64_t brick) {
  const BrickMesh& mesh = meshOf(brick);
  if (mesh.vertices == 0) return;
  std::int32_t at = mesh.firstVertex;
  if (mesh.signs.vertexCount() > 0)
    brickVertices(field, grid, brick, mesh.signs, points_.data() + at, edges_.data() + at);
  at += mesh.signs.vertexCount();
  if (mesh.wound != kNone)
    for (const BrickWound::Vertex& v : wounds_[std::size_t(mesh.wound)].vertices)
      points_[at++] = v.position;
  const std::int32_t end = mesh.firstVertex + RangeAllocator::roundedUp(mesh.vertices);
  while (at < end) points_[at++] = Vec3f::Zero();  // room to grow
}

std::int32_t SurfaceTracker::vertexCountOf(const BrickMesh& mesh) const {
  const std::size_t ofWound =
      mesh.wound == kNone ? 0 : wounds_[std::size_t(mesh.wound)].vertices.size();
  return mesh.signs.vertexCount() + std::int32_t(ofWound);
}

std::int32_t SurfaceTracker::triangleCountOf(const ColourField& field, std::int64_t brick) const {
  const BrickMesh& mesh = meshOf(brick);
  if (mesh.wound == kNone) return mesh.wholeTriangles;
  const BrickWound& cut = wounds_[std::size_t(mesh.wound)];
  const auto corners = cornerMasks(above(field, brick).inside);
  return countTriangles(corners, crossedCells(corners) & ~cut.cells) +
         std::int32_t(cut.triangles.size());
}

// Allocates the triangles of each brick whose triangles are written again.
void SurfaceTracker::placeTriangles(const ColourField& field) {
  for (const std::int64_t b : retriangulate_) {
    BrickMesh& mesh = meshOf(b);
    mesh.drawAgain = false;
    const std::int32_t count = triangleCountOf(field, b);
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
    if (count > 0) changes_.triangles.push_back({mesh.firstTriangle, count});
  }
  growTo(triangles_, std::size_t(triangleSpace_.end()));
}

}  // namespace resect
