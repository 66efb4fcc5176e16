#include "skills/metrics/two_hands.h"

#include <cmath>
#include <numeric>

#include "base/error.h"

namespace resect {

std::optional<double> correlation(std::span<const double> a, std::span<const double> b) {
  require(a.size() == b.size(), "{} speeds of one hand and {} of the other; give as many of both",
          a.size(), b.size());
  if (a.size() < 2) return {};
  const double n = double(a.size());
  const double meanA = std::accumulate(a.begin(), a.end(), 0.0) / n;
  const double meanB = std::accumulate(b.begin(), b.end(), 0.0) / n;
  double ab = 0, aa = 0, bb = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double x = a[i] - meanA, y = b[i] - meanB;
    ab += x * y, aa += x * x, bb += y * y;
  }
  if (!(aa > 0 && bb > 0)) return {};
  return ab / std::sqrt(aa * bb);
}

}  // namespace resect
