#include "sph/region.h"

#include <algorithm>

#include "base/error.h"

namespace resect {

bool Region::holds(const Vec3& p) const {
  require(
      isPlaced(),
      "the region is named by the organ and not yet placed; give what RegionPlacer makes of it");
  if (shape == Shape::Box && !box.contains(p)) return false;
  if (shape == Shape::Ball && !((p - centre).norm() <= radius)) return false;
  if (!asksDepth()) return true;
  const double depth = std::max(0.0, -(*skin)(p).distance);
  return depth >= shallowest && depth <= deepest;
}

std::optional<Vec3> landmarkPlace(const std::vector<Landmark>& landmarks, const std::string& name) {
  const auto found = std::find_if(landmarks.rbegin(), landmarks.rend(),
                                  [&](const Landmark& one) { return one.name == name; });
  if (found == landmarks.rend()) return std::nullopt;
  return found->place;
}

Region inWorld(Region region, const Aabb& box, const std::vector<Landmark>& landmarks) {
  if (!region.landmark.empty()) {
    const std::optional<Vec3> place = landmarkPlace(landmarks, region.landmark);
    if (!place) {
      std::string known;
      for (const Landmark& one : landmarks) known += (known.empty() ? "" : ", ") + one.name;
      throw error(
          "the organ has no landmark \"{}\"; {}", region.landmark,
          known.empty() ? "name places in the scenario's [organ.landmark]" : "known are: " + known);
    }
    region.centre = *place;
    region.frame = Region::Frame::Organ;
    region.landmark.clear();
  }
  if (region.frame == Region::Frame::Organ) {
    region.box = {pointInBox(box, region.box.min), pointInBox(box, region.box.max)};
    region.centre = pointInBox(box, region.centre);
    region.frame = Region::Frame::World;
  }
  return region;
}

}  // namespace resect
