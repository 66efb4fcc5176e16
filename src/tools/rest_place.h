// Finds the rest position of a point of the tissue from its present position in the world, and the
// present position from the rest position.
#pragma once

#include <optional>

#include "organ/organ.h"
#include "tissue/tissue_model.h"

namespace resect {

// The rest position, m, of the point of the tissue that is now at `world`. It is computed from the
// displacement and gradient of the nearest particle (cell of tissue). Returns none if no particle
// is within two spacings (sides of a cell) of `world` along each axis.
std::optional<Vec3> restPlace(const Organ& organ, const TissueModel& tissue, const Vec3& world);

// The present position in the world, m, of the point with the rest position `rest`. It is computed
// from the displacement and gradient of the particle that is nearest to `rest` in rest space. If no
// particle is near, returns `rest`.
Vec3 presentPlace(const Organ& organ, const TissueModel& tissue, const Vec3& rest);

}  // namespace resect
