// What heat does to an organ: vessels are sealed, tissue becomes stiffer.
#pragma once

#include <span>

#include "organ/operated_organ.h"

namespace resect {

// A frame of the organ's heat (heat/heat_field.h). removed: whether tissue was removed since the
// last call. Cost: the heated spots.
void heatOrgan(OperatedOrgan& organ, std::span<const HeatSource> sources, double duration,
               bool removed);

// Tissue that heat has coagulated: stiffer, harder to cut, and more brittle (estimates;
// elastography finds ablated liver several times as stiff, but the substep shortens with the
// stiffness).
TissueMaterial coagulated(const TissueMaterial& material);

}  // namespace resect
