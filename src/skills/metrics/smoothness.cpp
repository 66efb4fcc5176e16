#include "skills/metrics/smoothness.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "skills/metrics/spectrum.h"

namespace resect {
namespace {

constexpr double kHighest = 10, kLeastShare = 0.05;  // Hz; of the largest magnitude
constexpr int kPadding = 4;                          // factor 2^4

double peakOf(std::span<const double> speed) {
  double peak = 0;
  for (const double v : speed) peak = std::max(peak, std::abs(v));
  return peak;
}

}  // namespace

std::optional<double> spectralArcLength(std::span<const double> speed, double interval) {
  if (speed.size() < 3 || !(peakOf(speed) > 0)) return {};
  const std::size_t size = std::bit_ceil(speed.size()) << kPadding;
  const std::vector<double> spectrum = magnitudes(speed, size);
  const double largest = *std::ranges::max_element(spectrum);
  const double step = 1 / (double(size) * interval);  // Hz
  std::size_t first = spectrum.size(), last = 0;
  for (std::size_t i = 0; i < spectrum.size() && double(i) * step <= kHighest; ++i)
    if (spectrum[i] >= kLeastShare * largest) {
      first = std::min(first, i);
      last = i;
    }
  if (first >= last) return {};
  double length = 0;
  for (std::size_t i = first + 1; i <= last; ++i)
    length += std::hypot(1.0 / double(last - first), (spectrum[i] - spectrum[i - 1]) / largest);
  return -length;
}

std::optional<double> logDimensionlessJerk(std::span<const double> speed, double interval) {
  const double peak = peakOf(speed);
  if (speed.size() < 3 || !(peak > 0)) return {};
  double sum = 0;
  for (std::size_t i = 2; i < speed.size(); ++i) {
    const double jerk = (speed[i] - 2 * speed[i - 1] + speed[i - 2]) / (interval * interval);
    sum += jerk * jerk * interval;
  }
  const double duration = interval * double(speed.size());
  const double jerk = duration * duration * duration / (peak * peak) * sum;
  if (!(jerk > 1e-12)) return {};
  return -std::log(jerk);
}

}  // namespace resect
