// The parts of the picture that must be drawn again (damage).
//
// In software rendering a pixel costs some 200 ns. So when a tool moves over a still organ, only
// the pixels of the tool and of its shadow should be drawn again.
#pragma once

#include <Inventor/SbVec2s.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "geometry/aabb.h"

class SbViewportRegion;
class SoPerspectiveCamera;

namespace resect {

// What has changed since the last picture. Boxes are in world coordinates, m.
struct Damage {
  bool everything = false;    // the whole picture must be drawn again
  std::vector<Aabb> boxes;    // regions in which anything may have changed
  std::vector<Aabb> shadows;  // only soft shadows changed here; may be drawn some pictures later
  // Region whose content changes too slowly for the eye to follow, such as settling tissue. It may
  // be drawn a fraction of a second later, but then at full resolution.
  Aabb slow = {};
  // Whether there is nothing to draw now. `slow` is ignored.
  bool empty() const { return !everything && boxes.empty() && shadows.empty(); }
  void add(const Damage& other);
};

// Adds the box, and the regions in which an object in it casts a shadow: on the organ, on low
// objects on the table, and on the table's top, y = 0. lamp: position of the lamp, world, m. organ:
// the organ's box.
void addWithShadow(Damage& damage, const Aabb& box, const Vec3& lamp, const Aabb& organ);

// Pixels [left, right) x [bottom, top).
struct PixelRect {
  int left = 0, bottom = 0, right = 0, top = 0;
  bool empty() const { return left >= right || bottom >= top; }
  std::int64_t area() const {
    return empty() ? 0 : std::int64_t(right - left) * std::int64_t(top - bottom);
  }
};
// The smallest rectangle that contains both a and b.
inline PixelRect joined(const PixelRect& a, const PixelRect& b) {
  return {std::min(a.left, b.left), std::min(a.bottom, b.bottom), std::max(a.right, b.right),
          std::max(a.top, b.top)};
}
// The pixels of the viewport that can show any of the damage, as disjoint rectangles. If a box
// comes nearer to the camera than the near plane, the result is the whole picture.
std::vector<PixelRect> pixelsOf(const Damage& damage, const SoPerspectiveCamera& camera,
                                const SbViewportRegion& viewport);
// Sum of the rectangles' areas, pixels.
std::int64_t area(const std::vector<PixelRect>& parts);

}  // namespace resect
