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

// Whether there is tissue, or the wall of a bare vessel, at a place in rest space.
bool isTissue(const Organ& organ, const Vec3& place);
// Share of coagulated tissue, 0 to 1, at a place in rest space. The place must be inside tissue or
// on its surface.
double coagulatedAt(const Organ& organ, const Vec3& place);

// The material after heat has coagulated it: stiffer, harder to cut, and easier to tear. The
// figures are estimates. In measurements by elastography, ablated liver is several times as stiff
// as before the ablation. Here the stiffness is only doubled, since stiffer tissue needs shorter
// substeps.
TissueMaterial coagulated(const TissueMaterial& material);

}  // namespace resect
