// Directions in a liver: up, and from right to left about an axis near the vena cava. The
// directions turn with the liver, since they are found from the portal vein and the hepatic veins
// alone. In a mirrored liver right and left are exchanged.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "anatomy/anatomy.h"

namespace resect {

// For each segment of a vessel: the number of terminals (ends of the tree) in its subtree.
std::vector<std::int32_t> terminalsOf(const Anatomy& anatomy);

struct LiverFrame {
  Vec3 entry = Vec3::Zero();  // where the portal vein begins, m
  Vec3 fork = Vec3::Zero();   // the portal vein's fork: its first division into main branches, m
  Vec3 cava = Vec3::Zero();   // where the hepatic veins meet, m
  // Unit vectors at right angles. up: from `entry` to `cava`. The axis is the line through `cava`
  // in the direction `up`. On one side of the axis the liver extends least; `ahead` points away
  // from this side.
  Vec3 up = Vec3::Zero(), ahead = Vec3::Zero(), left = Vec3::Zero();
  // First segments of the right, middle and left hepatic vein.
  std::array<std::int32_t, 3> trunks{};

  // Empty in these cases: the portal vein has fewer than 20 terminals; the hepatic veins do not
  // have three main branches; the hepatic veins meet where the portal vein begins.
  static std::optional<LiverFrame> find(const Anatomy& anatomy);

  double height(const Vec3& place) const { return (place - fork).dot(up); }  // above the fork, m
  // Angle about the axis, rad: 0 in the direction `ahead`, positive on the left, negative on the
  // right.
  double angle(const Vec3& place) const;
};

}  // namespace resect
