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

// Whether heat finds tissue at a place in rest space, or the wall of a bare vessel.
bool isTissue(const Organ& organ, const Vec3& place);
// Share of coagulated tissue, 0 to 1, at a place in rest space on the surface of tissue or inside.
double coagulatedAt(const Organ& organ, const Vec3& place);

// The material after heat has coagulated it: stiffer, harder to cut, and easier to tear. The
// figures are estimates. Elastography finds ablated liver several times as stiff as before; here
// the stiffness is only doubled, since stiffer tissue needs shorter substeps.
TissueMaterial coagulated(const TissueMaterial& material);

}  // namespace resect
