// The quartic spline kernel M5 of the diploma thesis that Resect continues, corrected.
//
// Source: Schoenberg's quartic B-spline as used in SPH (Monaghan 1985). The thesis has two errors,
// which are corrected here. Let s = r / h. In the thesis, the formula for 0.5 <= s < 1.5 has the
// term 5 s^2 / 4 with a plus sign; the correct sign is minus. The factor 1 / pi of the thesis does
// not normalise the kernel in three dimensions; the correct factor is 6 / (5 pi).
#pragma once

#include <numbers>

namespace resect {

constexpr double kKernelSupport = 2.5;  // radius of the kernel, as a multiple of h

// The spline's shape for s = r / h >= 0. It is 0 from s = 2.5 on. The shape and its first three
// derivatives are continuous.
constexpr double kernelShape(double s) {
  const auto fourth = [](double x) { return x > 0 ? x * x * x * x : 0.0; };
  return (fourth(2.5 - s) - 5 * fourth(1.5 - s) + 10 * fourth(0.5 - s)) / 24;
}

// The derivative of kernelShape(s) with respect to s.
constexpr double kernelShapeSlope(double s) {
  const auto third = [](double x) { return x > 0 ? x * x * x : 0.0; };
  return (-third(2.5 - s) + 5 * third(1.5 - s) - 10 * third(0.5 - s)) / 6;
}

// The kernel W(r, h), 1/m^3, for the distance r >= 0, m, and the smoothing length h > 0, m. Its
// integral over space is 1.
constexpr double kernel(double r, double h) {
  return 6 / (5 * std::numbers::pi * h * h * h) * kernelShape(r / h);
}

// The derivative dW/dr of kernel(r, h), 1/m^4.
constexpr double kernelSlope(double r, double h) {
  return 6 / (5 * std::numbers::pi * h * h * h * h) * kernelShapeSlope(r / h);
}

}  // namespace resect
