// The parts of the picture that must be drawn again (damage).
//
// A pixel costs about 200 ns in software rendering. So when a tool moves over an organ that does
// not move, only the pixels of the tool and of its shadow should be drawn again.
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
  bool everything = false;  // the whole picture must be drawn again
  std::vector<Aabb> boxes;  // regions in which anything may have changed
  // Regions in which only soft shadows have changed. They may be drawn some pictures later.
  std::vector<Aabb> shadows;
  // A region that changes too slowly for the eye to follow, such as settling tissue. It may be
  // drawn a fraction of a second later, but must then be drawn at full resolution.
  Aabb slow = {};
  // Whether there is nothing that must be drawn now. `slow` is ignored.
  bool empty() const { return !everything && boxes.empty() && shadows.empty(); }
  void add(const Damage& other);
};

// Adds a box to the damage, and the regions in which an object in the box casts a shadow. Shadows
// fall on the organ, on low objects on the table, and on the table's top, y = 0. box, organ: boxes
// of the object and of the organ; world, m. lamp: position of the lamp; world, m.
void addWithShadow(Damage& damage, const Aabb& box, const Vec3& lamp, const Aabb& organ);

// A rectangle of pixels. It contains the columns `left` to right - 1 and the rows `bottom` to
// top - 1.
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
// The pixels of the viewport that can show the damage, as disjoint rectangles. The region
// Damage::slow is ignored. If a box of the damage extends beyond the near plane towards the camera,
// the result is the whole picture.
std::vector<PixelRect> pixelsOf(const Damage& damage, const SoPerspectiveCamera& camera,
                                const SbViewportRegion& viewport);
// Sum of the areas of the rectangles, pixels.
std::int64_t area(const std::vector<PixelRect>& parts);

}  // namespace resect
