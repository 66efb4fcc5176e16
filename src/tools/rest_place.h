// Where a place in the world lies in the tissue at rest.
#pragma once

#include <optional>

#include "organ/organ.h"
#include "tissue/tissue_model.h"

namespace resect {

// From the nearest particle within two cells of the place; none if there is no such particle.
std::optional<Vec3> restPlace(const Organ& organ, const TissueModel& tissue, const Vec3& world);

}  // namespace resect
