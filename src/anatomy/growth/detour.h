// Finds a way for a small vessel round other vessels.
#pragma once

#include <span>
#include <vector>

#include "anatomy/growth/organ_inside.h"
#include "anatomy/vessel_index.h"

namespace resect {

struct Surroundings {
  std::span<const VesselSegment> others;  // vessels to keep clear of
  const VesselIndex& index;               // index of `others`
  const OrganInside& inside;
  double gap, depth;  // least gap to other vessels; least depth below the surface; m
};

// Corners of the shortest way between two points on which a vessel of `radius`, m, has room. The
// search goes over grid points 0.7 mm apart, within 1 cm of the box round `from` and `to`. Each
// straight piece is at most `longest`, m. The way begins at `from` and ends at the grid point with
// room that is nearest to `to`. The result is empty if there is no way.
std::vector<Vec3> detour(const Vec3& from, const Vec3& to, double radius, double longest,
                         const Surroundings& around);

}  // namespace resect
