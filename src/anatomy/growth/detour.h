// The way of a small vessel round those that are in its way.
#pragma once

#include <span>
#include <vector>

#include "anatomy/growth/organ_inside.h"
#include "anatomy/vessel_index.h"

namespace resect {

struct Surroundings {
  std::span<const VesselSegment> others;  // vessels to keep clear of
  const VesselIndex& index;               // of `others`
  const OrganInside& inside;
  double gap, depth;  // least gap to other vessels and least depth below the surface, m
};

// Corners of the shortest way from a place to another on which a vessel of `radius`, m, has room,
// over places 0.7 mm apart; pieces of at most `longest`, m. The way begins at `from` and ends at
// the place with room that is nearest to `to`. Empty if there is none within 1 cm of both.
std::vector<Vec3> detour(const Vec3& from, const Vec3& to, double radius, double longest,
                         const Surroundings& around);

}  // namespace resect
