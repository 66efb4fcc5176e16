// Converts a position in the world to the position in rest space of the same point of the tissue,
// and back.
#pragma once

#include <optional>

#include "organ/organ.h"
#include "tissue/tissue_model.h"

namespace resect {

// The position in rest space of the point of the tissue that is at `world` now, m. It is found from
// the displacement and gradient of the nearest particle. None if no particle is within two cells.
std::optional<Vec3> restPlace(const Organ& organ, const TissueModel& tissue, const Vec3& world);

// The present position in the world of the point at `rest` in rest space, m. It is found from the
// particle that is nearest to `rest` in rest space; if no particle is near, `rest` is returned.
Vec3 presentPlace(const Organ& organ, const TissueModel& tissue, const Vec3& rest);

}  // namespace resect
