// The anatomical features of the visceral face.
//
// They are carved last, so that nothing fills them again.
#pragma once

#include <vector>

#include "shape_fit.h"

namespace fit_liver {

// In the frame of the Visible Human Male's liver, centred at its centre of volume. The groove and
// the fissure are starts, fitted like everything else within a leash. The fossa, last, is given:
// the measured gallbladder is nearly empty and hangs free, so its bed is set where the gallbladder
// lies, as deep as a filled one makes it.
std::vector<Part> namedParts();

}  // namespace fit_liver
