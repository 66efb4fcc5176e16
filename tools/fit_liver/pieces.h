// The ellipsoids that the fit starts from, and candidates for further ones.
#pragma once

#include <vector>

#include "base/random.h"
#include "reference_surface.h"
#include "shape_fit.h"

namespace fit_liver {

// Bodies from k-means of the liver's inside, then hollows from k-means of what its convex hull
// holds beyond it.
std::vector<Part> firstParts(const ReferenceSurface& reference, std::span<const Sample> even,
                             resect::Random& random);

// A piece where the shape is wrong most: added where liver is missing, carved where it is too much.
Part pieceForWorst(std::span<const Part> parts, std::span<const SamplePair> probes,
                   resect::Random& random);

}  // namespace fit_liver
