// Smoothness of a movement by its speed profile (Balasubramanian et al. 2015,
// 10.1186/s12984-015-0090-9). Both measures are dimensionless, and nearer to 0 for smoother
// movements.
#pragma once

#include <optional>
#include <span>

namespace resect {

// Spectral arc length: minus the length of the curve of the speed's normalised magnitude spectrum,
// from 0 to the last frequency, at most 10 Hz, at which it reaches 0.05. The spectrum is padded
// with zeros to 2^(ceil(log2 N) + 4) points. Nothing if the instrument does not move or fewer than
// 3 values are given. interval: s between values.
std::optional<double> spectralArcLength(std::span<const double> speed, double interval);

// Log dimensionless jerk: -ln(T^3 / v_peak^2 times the integral of (d2v/dt2)^2). Nothing in the
// same cases, and for a speed that changes linearly.
std::optional<double> logDimensionlessJerk(std::span<const double> speed, double interval);

}  // namespace resect
