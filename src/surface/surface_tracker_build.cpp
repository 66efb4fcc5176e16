// Meshes the whole surface in one pass over the bricks; updates after edits are in
// surface_tracker.cpp.
//
// A brick's vertices and triangles depend on the bricks above it. So the pass advances in short
// blocks of bricks, and each stage runs one layer of bricks behind the stage before it: its input
// was just written and is still in the second-level cache. Evaluating the nodes can be the first
// stage.
#include <algorithm>
#include <atomic>

#include "base/error.h"
#include "base/growth.h"
#include "base/instruction_set.h"
#include "base/parallel.h"
#include "surface/surface_tracker.h"

namespace resect {
namespace {

// Far from the numbers of all earlier builds and of their updates.
std::uint64_t nextBuild() {
  static std::atomic<std::uint64_t> builds{0};
  return ++builds << 32;
}

constexpr std::size_t kBuildGrain = 128;  // bricks per block of work: some 50 us
// Bricks that the pass advances by, for each thread: their nodes take a quarter of a megabyte.
constexpr std::size_t kStretch = 1024;

// Vertices and triangles reserved for each stored brick: a tenth more than a liver takes, rounding
// of ranges included. Memory that is not needed is not touched.
struct Expected {
  std::size_t vertices, triangles;
};
Expected expectedOf(const ColourField& field, std::size_t bricks) {
  return field.refine() == 1 ? Expected{14 * bricks, 25 * bricks}
                             : Expected{10 * bricks, 17 * bricks};
}

// resize(size); beyond the reserved size the array grows by half.
template <typename T>
void makeRoom(RawArray<T>& array, std::size_t size) {
  if (size > array.capacity()) reserveFor(array, size + size / 2);
  array.resize(size);
}

// Calls visit(begin, end) for blocks of [begin, end).
template <typename Visit>
void inBlocks(std::size_t begin, std::size_t end, Visit visit) {
  parallelFor(end - begin, kBuildGrain,
              [&](std::size_t first, std::size_t last) { visit(begin + first, begin + last); });
}

}  // namespace

FieldAndSurface buildFieldAndSurface(const Discretization& cells, int refine, float iso) {
  requireIso(iso);
  FieldAndSurface both{ColourField(cells, refine, ColourField::NodesLater()), {}};
  both.surface.iso_ = iso;
  const auto evaluate = [&](std::size_t begin, std::size_t end) {
    both.field.evaluateBuilt(begin, end);
  };
  const RangeBody body(evaluate);
  both.surface.meshAll(both.field, &body, nullptr);
  return both;
}

// Numbers the records of the bricks that will hold a mesh, and returns these bricks, ascending.
RawArray<std::int32_t> SurfaceTracker::numberRecords(const ColourField& field, const Wound* wound) {
  const auto bricks = std::size_t(field.brickCount());
  recordOf_.resize(bricks + std::size_t(field.brickIndex({1, 1, 1})));
  std::fill(recordOf_.begin() + std::ptrdiff_t(bricks), recordOf_.end(), kOutside);
  if (const auto built = field.builtBricks(); !wound && !built.empty()) {
    for (std::size_t b = 0; b < bricks; ++b) {
      const std::int32_t slot = field.slot(std::int64_t(b));
      recordOf_[b] = slot >= 0 ? slot + kFirstOwn : recordWithoutMesh(slot);
    }
    return {built.begin(), built.end()};
  }
  RawArray<std::int32_t> withMesh(bricks);
  std::int32_t count = 0;
  for (std::size_t b = 0; b < bricks; ++b) {
    const std::int32_t slot = field.slot(std::int64_t(b)), without = recordWithoutMesh(slot);
    const bool has =
        slot >= 0 || (without == kInside && wound && wound->severed.near(std::int64_t(b)));
    recordOf_[b] = has ? count + kFirstOwn : without;
    withMesh[std::size_t(count)] = std::int32_t(b);
    count += has;
  }
  withMesh.resize(std::size_t(count));
  return withMesh;
}

// Clears everything; `bricks` bricks will hold a mesh.
void SurfaceTracker::clear(const ColourField& field, std::size_t bricks) {
  bricks_.clear();
  reserveFor(bricks_, bricks + kFirstOwn);
  bricks_.resize(kFirstOwn);
  bricks_[kInside].signs.inside = ~std::uint64_t(0);
  freeRecords_.clear();
  wounds_.clear();
  freeWounds_.clear();
  vertexSpace_ = {};
  triangleSpace_ = {};
  points_.clear();
  edges_.clear();
  triangles_.clear();
  triangleCount_ = 0;
  const Expected expected = expectedOf(field, bricks);
  reserveFor(points_, expected.vertices);
  reserveFor(edges_, expected.vertices);
  reserveFor(triangles_, expected.triangles);
}

// Finds which nodes of the bricks [begin, end) of the pass are inside.
RESECT_WIDEST
void SurfaceTracker::tellInside(const ColourField& field, std::span<const std::int32_t> bricks,
                                std::size_t begin, std::size_t end) {
  for (std::size_t i = begin; i < end; ++i) {
    const std::int32_t slot = field.slot(bricks[i]);
    bricks_[i + kFirstOwn].signs.inside =
        slot >= 0 ? insideMask(field.values(slot), iso_) : ~std::uint64_t(0);
  }
}

// Allocates vertices and triangles for the bricks [begin, end) of the pass, and appends those that
// have any.
void SurfaceTracker::placeAll(const ColourField& field, std::span<const std::int32_t> bricks,
                              std::size_t begin, std::size_t end,
                              std::vector<std::int32_t>& surfaced) {
  for (std::size_t i = begin; i < end; ++i) {
    BrickMesh& mesh = bricks_[i + kFirstOwn];
    mesh.vertices = vertexCountOf(mesh);
    mesh.triangles = triangleCountOf(field, bricks[i]);
    if (mesh.vertices > 0) mesh.firstVertex = vertexSpace_.take(mesh.vertices);
    if (mesh.triangles > 0) mesh.firstTriangle = triangleSpace_.take(mesh.triangles);
    if (mesh.vertices + mesh.triangles > 0) surfaced.push_back(bricks[i]);
    triangleCount_ += mesh.triangles;
  }
  const auto vertices = std::size_t(vertexSpace_.end());
  makeRoom(points_, vertices);
  makeRoom(edges_, vertices);
  makeRoom(triangles_, std::size_t(triangleSpace_.end()));
}

// evaluate(begin, end): evaluates the nodes of field.builtBricks() [begin, end); null if all are
// known, as they must be with a wound.
void SurfaceTracker::meshAll(const ColourField& field, const RangeBody* evaluate,
                             const Wound* wound) {
  const RawArray<std::int32_t> bricks = numberRecords(field, wound);
  clear(field, bricks.size());
  changes_.vertices.clear();
  changes_.triangles.clear();
  changes_.bricks = std::int64_t(bricks.size());
  changes_.everything = true;
  changes_.number = nextBuild();
  lookIsDue({});

  const NodeGrid grid(field, iso_);
  const std::size_t stretch = kStretch * threadsAllowed();
  std::vector<std::int32_t> surfaced;  // bricks that hold a piece of the surface
  surfaced.reserve(bricks.size());
  // Distance to the last brick that a brick's vertices and triangles depend on.
  const std::int64_t reach = field.brickIndex({1, 1, 1});
  // How many of `all`, from `first` on, are independent of the bricks from index `done` on.
  const auto ready = [&](std::span<const std::int32_t> all, std::size_t first, std::size_t done) {
    if (done == bricks.size()) return all.size();
    while (first < all.size() && all[first] + reach < bricks[done]) ++first;
    return first;
  };
  for (std::size_t told = 0, placed = 0, written = 0, drawn = 0; placed < bricks.size();) {
    const std::size_t toTell = std::min(bricks.size(), told + stretch);
    bricks_.resize(toTell + kFirstOwn);
    inBlocks(told, toTell, [&](std::size_t begin, std::size_t end) {
      if (evaluate) (*evaluate)(begin, end);
      tellInside(field, bricks, begin, end);
    });
    told = toTell;
    const std::size_t toPlace = ready(bricks, placed, told);
    inBlocks(placed, toPlace, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) findCrossings(field, bricks[i]);
    });
    if (wound) {
      woundBricks_.clear();
      for (std::size_t i = placed; i < toPlace; ++i)
        if (wound->severed.near(bricks[i])) {
          takeWound(bricks_[i + kFirstOwn]);
          woundBricks_.push_back(bricks[i]);
        }
      meshWounds(field, *wound);
    }
    placeAll(field, bricks, placed, toPlace, surfaced);
    placed = toPlace;
    inBlocks(written, surfaced.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) writeVertices(field, grid, surfaced[i]);
    });
    written = surfaced.size();
    const std::size_t toDraw = ready(surfaced, drawn, placed);
    inBlocks(drawn, toDraw, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        if (meshOf(surfaced[i]).triangles > 0) drawTriangles(field, surfaced[i]);
    });
    drawn = toDraw;
  }
}

}  // namespace resect
