// Directions in a liver, in whatever position it lies: up, and from right to left about an axis
// near the vena cava. They are found from the portal vein and the hepatic veins alone. In a
// mirrored liver right and left are exchanged.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "anatomy/anatomy.h"

namespace resect {

// Number of terminals of each segment's subtree, by segment.
std::vector<std::int32_t> terminalsOf(const Anatomy& anatomy);

struct LiverFrame {
  Vec3 entry = Vec3::Zero();  // where the portal vein begins, m
  Vec3 fork = Vec3::Zero();   // the portal vein's fork: its first division into main branches, m
  Vec3 cava = Vec3::Zero();   // where the hepatic veins meet, m
  // Unit vectors at right angles. up: from `entry` to `cava`; this is the direction of the axis,
  // the line through `cava`. ahead: away from the side of the axis on which least of the liver
  // lies.
  Vec3 up = Vec3::Zero(), ahead = Vec3::Zero(), left = Vec3::Zero();
  // First segments of the right, middle and left hepatic vein.
  std::array<std::int32_t, 3> trunks{};

  // Empty if the portal vein has fewer than 20 terminals, or if the hepatic veins do not have three
  // main branches or meet where the portal vein begins.
  static std::optional<LiverFrame> find(const Anatomy& anatomy);

  double height(const Vec3& place) const { return (place - fork).dot(up); }  // above the fork, m
  // Angle about the axis, rad, from `ahead` towards `left`. So it grows from the right, where it is
  // negative, by the front to the left.
  double angle(const Vec3& place) const;
};

}  // namespace resect
