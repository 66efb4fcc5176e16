// The rise of temperature round a small source, for the tests of heat.
#pragma once

#include <cmath>
#include <numbers>

#include "heat/heat_field.h"

namespace resect::test {

// Rise at the distance r, m, from a source of `power`, W, that has been on for `time`, s, in
// endless perfused tissue. Pennes 1948 is linear, so that this follows from the point source of
// Carslaw and Jaeger 1959, 10.4.
inline double riseAround(double power, double r, double time) {
  const double a = kConductivity / kHeatCapacity;
  const double w = kPerfusion * kBloodCapacity / kHeatCapacity;
  const double inverse = std::sqrt(w / a);  // 1 / m
  const double x = r / std::sqrt(4 * a * time), y = std::sqrt(w * time);
  return power / (8 * std::numbers::pi * kConductivity * r) *
         (std::exp(-r * inverse) * std::erfc(x - y) + std::exp(r * inverse) * std::erfc(x + y));
}

}  // namespace resect::test
