// Finds a way for a small vessel round other vessels.
#pragma once

#include <span>
#include <vector>

#include "anatomy/growth/organ_inside.h"
#include "anatomy/vessel_index.h"

namespace resect {

struct Surroundings {
  std::span<const VesselSegment> others;  // vessels that the new vessel must not meet
  const VesselIndex& index;               // index of `others`
  const OrganInside& inside;
  // gap: least gap between the walls of the new vessel and of other vessels, m. depth: least depth
  // of the new vessel's wall below the organ's surface, m.
  double gap, depth;
};

// Finds the shortest way from `from` to `to` for a vessel with the radius `radius`, m, and returns
// the corners of this way. The search goes over grid points 0.7 mm apart, within 1 cm of the
// bounding box of `from` and `to`. Only grid points at which the vessel keeps the gap and the depth
// of `around` are used. The way begins at `from`. It ends at the usable grid point nearest to `to`.
// Each straight piece is at most `longest`, m. The result is empty if there is no way.
std::vector<Vec3> detour(const Vec3& from, const Vec3& to, double radius, double longest,
                         const Surroundings& around);

}  // namespace resect
