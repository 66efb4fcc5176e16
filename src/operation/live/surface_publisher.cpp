#include "operation/live/surface_publisher.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "blood/film/film_map.h"
#include "organ/picture/picture_heat.h"
#include "organ/picture/picture_structures.h"
#include "organ/picture/picture_vessels.h"

namespace resect {

void SurfacePublisher::follow(const PresentSurface& surface) {
  followShape(surface);
  if (surface.operated && (surface.organ.heat.changed() || heated_ || update_.everything)) {
    update_.heat = pictureHeat(*surface.operated);
    heated_ = surface.organ.heat.changed();
  }
  if (update_.everything) update_.structures = pictureStructures(surface.organ);
  if (!surface.film) return;
  if (!vessels_) vessels_ = pictureVessels(surface.organ.map->anatomy);
  if (update_.everything) update_.vessels = vessels_;
  const bool wet = !surface.film->wet().empty();
  if (wet || wet_ || update_.everything) update_.blood = filmMap(*surface.film, *surface.operated);
  wet_ = wet;
}

void SurfacePublisher::followShape(const PresentSurface& surface) {
  const SurfaceTracker& tracker = surface.organ.surface;
  const SurfaceTracker::Changes& changes = tracker.changes();
  // A viewer that falls behind gets the whole surface once instead of the same ranges many times.
  const bool late = update_.rest.size() > 2 * tracker.points().size() ||
                    update_.triangles.size() > 2 * tracker.triangles().size();
  const std::uint64_t last = std::exchange(followed_, changes.number);
  const bool missed = changes.number != last && changes.number != last + 1;
  if (!std::exchange(begun_, true) || update_.everything || changes.everything || late || missed)
    return tellEverything(surface);

  for (const IndexRange& r : changes.vertices)
    addNewVertices(update_, r, tracker.points(), tracker.cut());
  for (const IndexRange& r : changes.triangles) addNewTriangles(update_, r, tracker.triangles());
  if (!surface.moves) {
    for (const IndexRange& r : changes.vertices)
      addMovedVertices(update_, r, surface.points, surface.normals);
    return;
  }
  // Moved vertices of earlier steps are superseded.
  update_.movedVertices.clear(), update_.points.clear(), update_.normals.clear();
  findUnseen(surface.points, changes.vertices);
  for (std::size_t c = 0; c < unseen_.size(); ++c) {
    std::size_t end = c;
    while (end < unseen_.size() && unseen_[end]) ++end;
    if (end == c) continue;
    const std::int32_t first = std::int32_t(c) * kChunk;
    const std::int32_t last = std::min(std::int32_t(end) * kChunk, std::int32_t(told_.size()));
    addMovedVertices(update_, {first, last - first}, surface.points, surface.normals);
    c = end;
  }
}

void SurfacePublisher::tellEverything(const PresentSurface& surface) {
  const SurfaceTracker& tracker = surface.organ.surface;
  update_ = wholeSurface(surface.points, surface.normals, tracker.cut(), tracker.triangles(),
                         tracker.points());
  if (!surface.moves) return;
  told_.assign(surface.points.begin(), surface.points.end());
  unseen_.assign((told_.size() + kChunk - 1) / kChunk, 0);
}

// Marks the blocks with vertices that are new or have moved visibly.
void SurfacePublisher::findUnseen(std::span<const Vec3f> points,
                                  std::span<const IndexRange> changed) {
  const Vec3f nowhere = Vec3f::Constant(std::numeric_limits<float>::quiet_NaN());
  told_.resize(points.size(), nowhere);
  unseen_.resize((points.size() + kChunk - 1) / kChunk, 0);
  for (const IndexRange& r : changed)
    std::fill_n(told_.begin() + std::ptrdiff_t(r.first), r.count, nowhere);
  for (std::size_t c = 0; c < unseen_.size(); ++c) {
    const auto chunk = [&](auto span) {
      return span.subspan(c * kChunk, std::min<std::size_t>(kChunk, span.size() - c * kChunk));
    };
    const std::span<Vec3f> before = chunk(std::span(told_));
    const std::span<const Vec3f> now = chunk(points);
    const bool same = std::ranges::equal(before, now, [&](const Vec3f& p, const Vec3f& q) {
      return (p - q).squaredNorm() <= seenMotion_ * seenMotion_;
    });
    if (same) continue;
    unseen_[c] = 1;
    std::ranges::copy(now, before.begin());
  }
}

SurfaceUpdate SurfacePublisher::take() {
  unseen_.assign(unseen_.size(), 0);
  return std::exchange(update_, {});
}

}  // namespace resect
