#include "inventor/gl/damage.h"

#include <Inventor/SbViewVolume.h>
#include <Inventor/SbViewportRegion.h>
#include <Inventor/nodes/SoPerspectiveCamera.h>

#include <algorithm>
#include <cmath>

#include "inventor/gl/camera_moves.h"

namespace resect {
namespace {

constexpr double kFurniture = 0.03;  // m: height of the tool box
constexpr int kMargin = 3;           // pixels
constexpr int kTile = 16;            // pixels

// The tiles that the rectangles touch, as disjoint rectangles.
std::vector<PixelRect> withoutOverlap(const std::vector<PixelRect>& parts, int width, int height) {
  const int columns = (width + kTile - 1) / kTile, rows = (height + kTile - 1) / kTile;
  std::vector<std::uint8_t> touched(std::size_t(columns) * std::size_t(rows));
  for (const PixelRect& part : parts)
    for (int row = part.bottom / kTile; row * kTile < part.top; ++row)
      for (int column = part.left / kTile; column * kTile < part.right; ++column)
        touched[std::size_t(row * columns + column)] = 1;
  std::vector<PixelRect> result;
  std::size_t before = 0;  // the first rectangle that ends at the row below
  for (int row = 0; row < rows; ++row) {
    const std::size_t first = result.size();
    for (int column = 0; column < columns; ++column) {
      if (!touched[std::size_t(row * columns + column)]) continue;
      const int begin = column;
      while (column < columns && touched[std::size_t(row * columns + column)]) ++column;
      const PixelRect run{begin * kTile, row * kTile, std::min(column * kTile, width),
                          std::min((row + 1) * kTile, height)};
      const auto below =
          std::find_if(result.begin() + std::ptrdiff_t(before),
                       result.begin() + std::ptrdiff_t(first), [&](const PixelRect& r) {
                         return r.top == run.bottom && r.left == run.left && r.right == run.right;
                       });
      if (below != result.begin() + std::ptrdiff_t(first))
        below->top = run.top;
      else
        result.push_back(run);
    }
    // Extended rectangles may be extended again.
    while (before < result.size() && result[before].top <= row * kTile) ++before;
  }
  return result;
}

}  // namespace

void Damage::add(const Damage& other) {
  everything = everything || other.everything;
  boxes.insert(boxes.end(), other.boxes.begin(), other.boxes.end());
  shadows.insert(shadows.end(), other.shadows.begin(), other.shadows.end());
  slow.grow(other.slow);
}

void addWithShadow(Damage& damage, const Aabb& box, const Vec3& lamp, const Aabb& organ) {
  if (box.empty()) return;
  damage.boxes.push_back(box.padded(0.002));
  if (box.max.y() >= lamp.y() - 0.01) {
    damage.everything = true;
    return;
  }
  // The bounding box of a slanted shadow volume is too wide; boxes per layer of height are tighter.
  // Above the furniture on the table shadows can fall only on the organ.
  constexpr int kLayers = 5;
  const double ceiling = std::max(organ.max.y(), 2 * kFurniture);
  for (int layer = 0; layer <= kLayers; ++layer) {
    const double step = (ceiling - kFurniture) / kLayers,
                 low = layer ? kFurniture + (layer - 1) * step : 0,
                 high = layer ? low + step : kFurniture;
    Aabb beam;
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 p = box.corner(corner);
      for (const double height : {low, high})
        beam.grow(Vec3(p + std::max(0.0, p.y() - height) / (lamp.y() - p.y()) * (p - lamp)));
    }
    beam.min.y() = std::max(beam.min.y(), low);
    beam.max.y() = std::min(beam.max.y(), high);
    // Shadows get softer with distance.
    const double soft = std::min(0.008 + 0.08 * std::max(box.max.y() - low, 0.0), 0.03);
    const Vec3 margin(soft, 0.002, soft);
    beam = {beam.min - margin, beam.max + margin};
    if (beam.empty()) continue;
    if (layer == 0 || !intersection(beam, organ.padded(0.02)).empty())
      damage.shadows.push_back(beam);
  }
}

std::vector<PixelRect> pixelsOf(const Damage& damage, const SoPerspectiveCamera& camera,
                                const SbViewportRegion& viewport) {
  const SbVec2s size = viewport.getViewportSizePixels();
  std::vector<PixelRect> all{{0, 0, size[0], size[1]}};
  if (damage.everything) return all;
  const SbViewVolume volume = viewVolumeOf(camera, viewport);
  SbVec3f ahead;
  camera.orientation.getValue().multVec(SbVec3f(0, 0, -1), ahead);
  const SbVec3f eye = camera.position.getValue();
  std::vector<PixelRect> parts;
  std::vector<Aabb> boxes = damage.boxes;
  boxes.insert(boxes.end(), damage.shadows.begin(), damage.shadows.end());
  for (const Aabb& box : boxes) {
    PixelRect rect{size[0], size[1], 0, 0};
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3f p = box.corner(corner).cast<float>();
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
  return withoutOverlap(parts, size[0], size[1]);
}

std::int64_t area(const std::vector<PixelRect>& parts) {
  std::int64_t sum = 0;
  for (const PixelRect& part : parts) sum += part.area();
  return sum;
}

}  // namespace resect
