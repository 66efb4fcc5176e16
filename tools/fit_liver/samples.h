// The sample points at which the shape is compared with the measured liver.
#pragma once

#include <vector>

#include "base/random.h"
#include "reference_surface.h"
#include "shape_fit.h"

namespace fit_liver {

// Around the standard normal distribution's zero.
double normal(resect::Random& random);

// First `even` pairs spread evenly in the padded box, then `near` pairs around the surface,
// thickest where it bends most: the sharp inferior margin is little of the area and much of the
// looks.
std::vector<SamplePair> samplesAround(const ReferenceSurface& reference, int even, int near,
                                      resect::Random& random);

}  // namespace fit_liver
