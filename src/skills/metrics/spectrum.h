// The spectrum of a speed profile.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace resect {

// Magnitudes of the discrete Fourier transform of the values, from frequency 0 to the highest
// frequency: size / 2 + 1 numbers. Before the transform, zeros are appended until there are `size`
// values. size: a power of two. Computed by kissfft, which Eigen contains.
std::vector<double> magnitudes(std::span<const double> values, std::size_t size);

// Frequency, Hz, below which 95 % of the power of the speed lies, after the mean speed has been
// subtracted. No result if the speed does not vary. interval: s between values.
std::optional<double> frequency95(std::span<const double> speed, double interval);

}  // namespace resect
