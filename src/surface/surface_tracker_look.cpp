// Normals and cut shares of the surface, made when a picture needs them.
#include <algorithm>

#include "base/error.h"
#include "base/growth.h"
#include "base/parallel.h"
#include "isosurface/brick_look.h"
#include "surface/surface_tracker.h"

namespace resect {
namespace {

constexpr std::size_t kLookGrain = 64;  // bricks per block of work: some 50 us

}  // namespace

void SurfaceTracker::lookIsDue(std::span<const std::int64_t> bricks) {
  // Without calls of updateLook() the list would grow without limit.
  allLookDue_ = allLookDue_ || changes_.everything ||
                lookDue_.size() + bricks.size() > std::size_t(recordOf_.size());
  if (allLookDue_)
    lookDue_.clear();
  else
    lookDue_.insert(lookDue_.end(), bricks.begin(), bricks.end());
}

void SurfaceTracker::updateLook(const ColourField& field) {
  growTo(normals_, points_.size());
  growTo(cut_, points_.size());
  if (allLookDue_) {
    lookDue_.clear();
    for (std::int64_t b = 0; b < field.brickCount(); ++b)
      if (hasMesh(b)) lookDue_.push_back(b);
  }
  // Bricks of several updates, each once.
  std::sort(lookDue_.begin(), lookDue_.end());
  lookDue_.erase(std::unique(lookDue_.begin(), lookDue_.end()), lookDue_.end());
  const NodeGrid grid(field, iso_);
  parallelFor(lookDue_.size(), kLookGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      if (hasMesh(lookDue_[i])) writeLook(field, grid, lookDue_[i]);
  });
  lookDue_.clear();
  allLookDue_ = false;
}

void SurfaceTracker::writeLook(const ColourField& field, const NodeGrid& grid, std::int64_t brick) {
  const BrickMesh& mesh = meshOf(brick);
  if (mesh.vertices == 0) return;
  auto at = std::size_t(mesh.firstVertex);
  const auto onEdges = std::size_t(mesh.signs.vertexCount());
  if (onEdges > 0)
    brickLook(field, grid, brick, {edges_.data() + at, onEdges}, normals_.data() + at,
              cut_.data() + at);
  at += onEdges;
  const auto write = [&](const Vec3f& normal, float cut) {
    normals_[at] = normal;
    cut_[at++] = cut;
  };
  if (mesh.wound != kNone)
    for (const BrickWound::Vertex& v : wounds_[std::size_t(mesh.wound)].vertices)
      write(v.normal, v.cut);
  const auto end = std::size_t(mesh.firstVertex + RangeAllocator::roundedUp(mesh.vertices));
  while (at < end) write(Vec3f::UnitY(), 0);  // room to grow
}

void SurfaceTracker::requireLook() const {
  require(!allLookDue_ && lookDue_.empty(),
          "how the surface looks was not made since it changed; call updateLook() first");
}

std::span<const Vec3f> SurfaceTracker::normals() const {
  requireLook();
  return normals_;
}

std::span<const float> SurfaceTracker::cut() const {
  requireLook();
  return cut_;
}

}  // namespace resect
