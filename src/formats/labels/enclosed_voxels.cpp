#include "formats/labels/enclosed_voxels.h"

#include <algorithm>
#include <cmath>

namespace resect {
namespace {

constexpr double kReach = 0.025;  // m
constexpr int kFewestAxes = 2;    // along which the organ lies on both sides

enum : std::uint8_t { kOutside, kVessel, kOrgan };

// Adds `direction` to `met` of each vessel voxel from which the organ lies within `reach` voxels
// against the direction of `step`.
void lookAlong(const std::vector<std::uint8_t>& kind, std::vector<std::uint8_t>& met,
               std::size_t first, std::ptrdiff_t step, int count, int reach,
               std::uint8_t direction) {
  int since = reach + 1;  // voxels since the organ
  std::ptrdiff_t at = std::ptrdiff_t(first);
  for (int i = 0; i < count; ++i, at += step) {
    if (kind[std::size_t(at)] == kOrgan)
      since = 0;
    else if (++since <= reach && kind[std::size_t(at)] == kVessel)
      met[std::size_t(at)] |= direction;
  }
}

}  // namespace

LabelImage withEnclosed(LabelImage image, std::span<const int> organ,
                        std::span<const int> vessels) {
  std::vector<std::uint8_t> kinds(image.labels.size() + 1, kOutside);
  for (const int i : vessels) kinds[std::size_t(i) + 1] = kVessel;
  for (const int i : organ) kinds[std::size_t(i) + 1] = kOrgan;
  std::vector<std::uint8_t> kind(std::size_t(image.voxelCount()), kOutside), met(kind.size(), 0);
  for (const RawArray<std::uint16_t>& layer : image.layers)
    for (std::size_t i = 0; i < layer.size(); ++i) kind[i] = std::max(kind[i], kinds[layer[i]]);

  const Vec3i& n = image.dims;
  const std::size_t steps[] = {1, std::size_t(n.x()), std::size_t(n.x()) * std::size_t(n.y())};
  for (int axis = 0; axis < 3; ++axis) {
    const int u = axis == 0 ? 1 : 0, v = axis == 2 ? 1 : 2;
    const int reach = int(std::ceil(kReach / image.spacing()[axis]));
    const auto step = std::ptrdiff_t(steps[axis]);
    for (int j = 0; j < n[v]; ++j)
      for (int i = 0; i < n[u]; ++i) {
        const std::size_t low = steps[u] * std::size_t(i) + steps[v] * std::size_t(j);
        lookAlong(kind, met, low, step, n[axis], reach, std::uint8_t(1 << 2 * axis));
        lookAlong(kind, met, low + steps[axis] * std::size_t(n[axis] - 1), -step, n[axis], reach,
                  std::uint8_t(2 << 2 * axis));
      }
  }
  const auto organNumber = std::uint16_t(organ[0] + 1);
  RawArray<std::uint16_t>& layer =
      image.layers[std::size_t(image.labels[std::size_t(organ[0])].layer)];
  const auto axesBetween = [](int directions) {
    int axes = 0;
    for (int axis = 0; axis < 3; ++axis) axes += (directions >> 2 * axis & 3) == 3;
    return axes;
  };
  for (std::size_t i = 0; i < kind.size(); ++i)
    if (kind[i] == kVessel && axesBetween(met[i]) >= kFewestAxes) layer[i] = organNumber;
  return image;
}

}  // namespace resect
