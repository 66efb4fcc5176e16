// Measures of how close a shape is to the measured liver.
#pragma once

#include "reference_surface.h"
#include "shape_fit.h"

namespace fit_liver {

struct Quality {
  double dice;         // overlap, 0 to 1
  double volumeRatio;  // to the measured volume
  double distance;     // m, mean over the measured surface
  double normalError;  // degrees, root mean square over the measured surface: what the eye sees
  bool onePiece;       // without cavities and handles
};

// `even`: samples spread evenly in space.
Quality quality(std::span<const Part> parts, const ReferenceSurface& reference,
                std::span<const Sample> even);

}  // namespace fit_liver
