// Where a place in the world lies in the tissue at rest, and the other way round.
#pragma once

#include <optional>

#include "organ/organ.h"
#include "tissue/tissue_model.h"

namespace resect {

// From the nearest particle within two cells of the place; none if there is no such particle.
std::optional<Vec3> restPlace(const Organ& organ, const TissueModel& tissue, const Vec3& world);

// Where a place at rest is now, by the particle that was nearest to it; if there is none near it,
// where it was at rest.
Vec3 presentPlace(const Organ& organ, const TissueModel& tissue, const Vec3& rest);

}  // namespace resect
