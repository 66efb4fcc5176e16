#include "skills/metrics/learning_curve.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace resect {

std::vector<double> cusum(std::span<const double> values, double target) {
  std::vector<double> sums;
  double sum = 0;
  for (const double x : values) sums.push_back(sum += x - target);
  return sums;
}

std::vector<double> learningCusum(const std::vector<bool>& passed, const LearningTest& test) {
  require(test.adequate > 0 && test.adequate < test.inadequate && test.inadequate < 1,
          "adequate and inadequate failure rates are {} and {}; give two numbers between 0 and 1, "
          "the adequate one less",
          test.adequate, test.inadequate);
  const double success = std::log((1 - test.adequate) / (1 - test.inadequate));
  const double failure = std::log(test.adequate / test.inadequate);
  std::vector<double> sums;
  double sum = 0;
  for (const bool one : passed)
    sums.push_back(sum = std::max(0.0, sum + (one ? success : failure)));
  return sums;
}

std::optional<std::size_t> competentAt(std::span<const double> curve, const LearningTest& test) {
  const auto at = std::ranges::find_if(curve, [&](double s) { return s >= test.signal; });
  if (at == curve.end()) return {};
  return std::size_t(at - curve.begin());
}

}  // namespace resect
