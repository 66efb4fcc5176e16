// Smoothness of a movement, computed from its speed profile (Balasubramanian et al. 2015,
// 10.1186/s12984-015-0090-9). Both measures are dimensionless. The smoother a movement is, the
// nearer both measures are to 0.
#pragma once

#include <optional>
#include <span>

namespace resect {

// Spectral arc length: minus the arc length of the curve of the speed's normalised magnitude
// spectrum. The curve begins at frequency 0. It ends at the highest frequency, up to 10 Hz, at
// which the normalised magnitude is at least 0.05. The N speeds are padded with zeros to
// 2^(ceil(log2 N) + 4) values before the transform. No result if the instrument does not move, or
// if fewer than 3 values are given. interval: s between values.
std::optional<double> spectralArcLength(std::span<const double> speed, double interval);

// Log dimensionless jerk: -ln(T^3 / v_peak^2 times the integral of (d2v/dt2)^2), where v is the
// speed and T the duration. No result if the instrument does not move, if fewer than 3 values are
// given, or if the speed changes linearly with time.
std::optional<double> logDimensionlessJerk(std::span<const double> speed, double interval);

}  // namespace resect
