// How two hands work together: the correlation of the speeds of two tips (after Hofstad et al.
// 2013, 10.1007/s00464-012-2524-9).
#pragma once

#include <optional>
#include <span>

namespace resect {

// Pearson's correlation, -1 to 1. No result if there are fewer than 2 pairs of values, or if `a` or
// `b` does not vary. `a` and `b` must have the same number of values.
std::optional<double> correlation(std::span<const double> a, std::span<const double> b);

}  // namespace resect
