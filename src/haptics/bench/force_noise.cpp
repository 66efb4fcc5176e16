#include "haptics/bench/force_noise.h"

#include <algorithm>
#include <cmath>

namespace resect {
namespace {

constexpr std::size_t kWindow = 200;  // samples
constexpr float kLeastForce = 0.05f;  // N

// rms about a polynomial of degree 4, as a share of the mean magnitude.
double noiseIn(std::span<const HapticSample> window) {
  const auto count = Eigen::Index(window.size());
  Eigen::MatrixXd powers(count, 5), forces(count, 3);
  const double from = window.front().time, span = window.back().time - from;
  double mean = 0;
  for (Eigen::Index i = 0; i < count; ++i) {
    const HapticSample& sample = window[std::size_t(i)];
    const double x = 2 * (sample.time - from) / span - 1;
    powers.row(i) << 1, x, x * x, x * x * x, x * x * x * x;
    forces.row(i) = sample.force.cast<double>();
    mean += double(sample.force.norm()) / double(count);
  }
  const Eigen::MatrixXd fit =
      (powers.transpose() * powers).ldlt().solve(powers.transpose() * forces);
  return std::sqrt((powers * fit - forces).squaredNorm() / double(count)) / mean;
}

}  // namespace

ForceNoise forceNoise(std::span<const HapticSample> samples) {
  ForceNoise noise;
  double squares = 0;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (!samples[i].still || samples[i].force.norm() < kLeastForce) {
      begin = i + 1;
    } else if (i + 1 - begin == kWindow) {
      const double one = noiseIn(samples.subspan(begin, kWindow));
      squares += one * one;
      noise.worst = std::max(noise.worst, one);
      ++noise.windows;
      begin = i + 1;
    }
  }
  if (noise.windows > 0) noise.typical = std::sqrt(squares / double(noise.windows));
  return noise;
}

}  // namespace resect
