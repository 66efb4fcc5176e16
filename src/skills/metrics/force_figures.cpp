#include "skills/metrics/force_figures.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace resect {

ForceFigures forceFigures(std::span<const double> force) {
  std::vector<double> felt;
  std::ranges::copy_if(force, std::back_inserter(felt), [](double f) { return f > 0; });
  if (felt.empty()) return {};
  std::ranges::sort(felt);
  const double count = double(felt.size());
  ForceFigures figures;
  figures.peak = felt.back();
  figures.p95 = felt[std::size_t(std::ceil(0.95 * count)) - 1];
  figures.mean = std::accumulate(felt.begin(), felt.end(), 0.0) / count;
  double sum = 0;
  for (const double f : felt) sum += (f - figures.mean) * (f - figures.mean);
  figures.deviation = std::sqrt(sum / count);
  return figures;
}

std::vector<SampleRange> forceErrors(std::span<const double> force, double limit) {
  std::vector<SampleRange> errors;
  for (std::size_t i = 0; i < force.size(); ++i) {
    if (!(force[i] > limit)) continue;
    if (!errors.empty() && errors.back().last + 1 == i)
      errors.back().last = i;
    else
      errors.push_back({i, i});
  }
  return errors;
}

}  // namespace resect
