#include "tissue/stencil.h"

#include <cmath>

#include "sph/kernel.h"

namespace resect {

std::array<double, 4> bondWeights() {
  constexpr double kSmoothing = 0.8;  // in spacings
  std::array<double, 4> weights{};
  for (int kind = 1; kind <= 3; ++kind) {
    const double r = std::sqrt(double(kind));
    weights[kind] = -kernelSlope(r, kSmoothing) / r;
  }
  return weights;
}

}  // namespace resect
