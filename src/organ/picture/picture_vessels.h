// An organ's vessels as viewers draw them on cut faces.
#pragma once

#include <memory>

#include "anatomy/anatomy.h"
#include "surface/vessel_picture.h"

namespace resect {

// Thickness of a vessel's wall, m, with the sheath of connective tissue round portal triads. That
// of a portal branch is a fifth of its radius, that of a hepatic vein hardly any (Gray's Anatomy,
// 41st ed., ch. 67). radius: of the lumen, m.
double wallOf(VesselKind kind, double radius);

// Null for an anatomy without vessels. Cost: each segment and the bins near it.
std::shared_ptr<const VesselPicture> pictureVessels(const Anatomy& anatomy);

}  // namespace resect
