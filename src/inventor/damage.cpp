#include "inventor/damage.h"

#include <Inventor/SbViewVolume.h>
#include <Inventor/SbViewportRegion.h>
#include <Inventor/nodes/SoPerspectiveCamera.h>

#include <algorithm>
#include <cmath>

#include "inventor/camera_moves.h"

namespace resect {
namespace {

constexpr double kPenumbra = 0.03;  // m: how far soft shadows reach beyond hard ones
constexpr int kMargin = 3;          // pixels
constexpr int kPassPixels = 15000;  // what one more pass over the scene costs, in pixels

Vec3 cornerOf(const Aabb& box, int corner) {
  return {corner & 1 ? box.max.x() : box.min.x(), corner & 2 ? box.max.y() : box.min.y(),
          corner & 4 ? box.max.z() : box.min.z()};
}

}  // namespace

void addWithShadow(Damage& damage, const Aabb& box, const Vec3& lamp, double ceiling) {
  if (box.empty()) return;
  damage.boxes.push_back(box.padded(0.002));
  if (box.max.y() >= lamp.y() - 0.01) {
    damage.everything = true;
    return;
  }
  // The box of the slanted beam is wide where it need not be: in slices it is not.
  constexpr int kSlices = 4;
  for (int s = 0; s < kSlices; ++s) {
    Aabb slice;
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 p = cornerOf(box, corner);
      const double fall = lamp.y() - p.y();
      const double begin = std::max(0.0, p.y() - ceiling) / fall, end = std::max(0.0, p.y()) / fall;
      for (const double share : {double(s) / kSlices, double(s + 1) / kSlices})
        slice.grow(Vec3(p + (begin + share * (end - begin)) * (p - lamp)));
    }
    damage.boxes.push_back(slice.padded(kPenumbra));
  }
}

std::vector<PixelRect> pixelsOf(const Damage& damage, const SoPerspectiveCamera& camera,
                                const SbViewportRegion& viewport) {
  const SbVec2s size = viewport.getViewportSizePixels();
  const std::vector<PixelRect> all{{0, 0, size[0], size[1]}};
  if (damage.everything) return all;
  const SbViewVolume volume = viewVolumeOf(camera, viewport);
  SbVec3f ahead;
  camera.orientation.getValue().multVec(SbVec3f(0, 0, -1), ahead);
  const SbVec3f eye = camera.position.getValue();
  std::vector<PixelRect> parts;
  for (const Aabb& box : damage.boxes) {
    PixelRect rect{size[0], size[1], 0, 0};
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3f p = cornerOf(box, corner).cast<float>();
      const SbVec3f world(p.x(), p.y(), p.z());
      if ((world - eye).dot(ahead) < camera.nearDistance.getValue()) return all;
      SbVec3f screen;
      volume.projectToScreen(world, screen);
      const float x = std::clamp(screen[0], -1.0f, 2.0f) * size[0],
                  y = std::clamp(screen[1], -1.0f, 2.0f) * size[1];
      rect.left = std::min(rect.left, int(std::floor(x)) - kMargin);
      rect.right = std::max(rect.right, int(std::ceil(x)) + kMargin);
      rect.bottom = std::min(rect.bottom, int(std::floor(y)) - kMargin);
      rect.top = std::max(rect.top, int(std::ceil(y)) + kMargin);
    }
    rect.left = std::max(rect.left, 0);
    rect.bottom = std::max(rect.bottom, 0);
    rect.right = std::min<int>(rect.right, size[0]);
    rect.top = std::min<int>(rect.top, size[1]);
    if (!rect.empty()) parts.push_back(rect);
  }
  // Two become one while that is no more to draw; each costs a pass over the scene.
  const auto joined = [](const PixelRect& a, const PixelRect& b) {
    return PixelRect{std::min(a.left, b.left), std::min(a.bottom, b.bottom),
                     std::max(a.right, b.right), std::max(a.top, b.top)};
  };
  for (bool again = true; again;) {
    again = false;
    for (std::size_t i = 0; i < parts.size(); ++i)
      for (std::size_t j = i + 1; j < parts.size();) {
        const PixelRect both = joined(parts[i], parts[j]);
        if (both.area() > parts[i].area() + parts[j].area() + kPassPixels) {
          ++j;
          continue;
        }
        parts[i] = both;
        parts.erase(parts.begin() + std::ptrdiff_t(j));
        again = true;
      }
  }
  return parts;
}

std::int64_t area(const std::vector<PixelRect>& parts) {
  std::int64_t sum = 0;
  for (const PixelRect& part : parts) sum += part.area();
  return sum;
}

}  // namespace resect
