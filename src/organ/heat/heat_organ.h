// Effects of heat on an organ: vessels are sealed, and tissue becomes stiffer.
#pragma once

#include <span>

#include "organ/operated_organ.h"

namespace resect {

// Computes a frame of the organ's heat (heat/heat_field.h) and applies its effects. duration: of
// the frame, s. removed: whether tissue was removed since the last call. Cost: proportional to the
// number of heated spots.
void heatOrgan(OperatedOrgan& organ, std::span<const HeatSource> sources, double duration,
               bool removed);

// The material after heat has coagulated it: stiffer, harder to cut, and easier to tear. The
// figures are estimates. Elastography finds ablated liver several times as stiff as before; here
// the stiffness is only doubled, since stiffer tissue needs shorter substeps.
TissueMaterial coagulated(const TissueMaterial& material);

}  // namespace resect
