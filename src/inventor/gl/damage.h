// The parts of the picture that must be drawn again (damage).
//
// In software rendering a pixel costs some 200 ns. So when a tool moves over a still organ, no more
// than its own pixels and those of its shadow should be redrawn.
#pragma once

#include <Inventor/SbVec2s.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "geometry/aabb.h"

class SbViewportRegion;
class SoPerspectiveCamera;

namespace resect {

// What has changed since the last picture, as boxes in the world, m.
struct Damage {
  bool everything = false;
  std::vector<Aabb> boxes;
  std::vector<Aabb> shadows;  // only soft shadows changed: may be drawn some pictures later
  bool empty() const { return !everything && boxes.empty() && shadows.empty(); }
  void add(const Damage& other);
};

// Adds the box, and the region in which it casts its shadow when lit from `lamp` (world, m): on the
// organ, whose box is `organ`, on low objects on the table, and on the table's top, y = 0.
void addWithShadow(Damage& damage, const Aabb& box, const Vec3& lamp, const Aabb& organ);

// Pixels [left, right) x [bottom, top).
struct PixelRect {
  int left = 0, bottom = 0, right = 0, top = 0;
  bool empty() const { return left >= right || bottom >= top; }
  std::int64_t area() const {
    return empty() ? 0 : std::int64_t(right - left) * std::int64_t(top - bottom);
  }
};
// The smallest rectangle that contains both.
inline PixelRect joined(const PixelRect& a, const PixelRect& b) {
  return {std::min(a.left, b.left), std::min(a.bottom, b.bottom), std::max(a.right, b.right),
          std::max(a.top, b.top)};
}
// The pixels of the viewport that can show any of the damage, as disjoint rectangles. A box that
// extends behind the camera counts as the whole picture.
std::vector<PixelRect> pixelsOf(const Damage& damage, const SoPerspectiveCamera& camera,
                                const SbViewportRegion& viewport);
// Sum of the rectangles' areas, pixels.
std::int64_t area(const std::vector<PixelRect>& parts);

}  // namespace resect
