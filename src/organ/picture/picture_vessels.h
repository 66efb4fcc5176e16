// An organ's vessels as viewers draw them on cut faces.
#pragma once

#include <memory>

#include "anatomy/anatomy.h"
#include "surface/vessel_picture.h"

namespace resect {

// Thickness of a vessel's wall, m. It includes the sheath of connective tissue round a portal triad
// (a branch of the portal vein with an artery and a bile duct). For a portal branch the thickness
// is about a fifth of the radius; a hepatic vein has hardly any sheath (Gray's Anatomy, 41st ed.,
// ch. 67). radius: of the lumen, m.
double wallOf(VesselKind kind, double radius);

// Null for an anatomy without vessels. Cost: proportional to the number of segments, and to the
// number of bins of the picture's grid near the segments.
std::shared_ptr<const VesselPicture> pictureVessels(const Anatomy& anatomy);

}  // namespace resect
