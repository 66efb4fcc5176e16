// How the radius r of a vessel depends on the number n of terminals (last branches) that the vessel
// feeds: r is proportional to n^(1/2.8). The exponent 1/2.8 lies between two others: 1/3 in
// Murray's law, and 1/2 for a constant flow speed, as in large vessels.
#pragma once

#include <cmath>

namespace resect {

// n^(1/2.8) for n > 0, with the same bits on every machine: the 7th root of n^5 by Newton's
// iteration, then a square root.
inline double murrayShare(double n) {
  const double c = n * n * n * n * n;
  int exponent;
  std::frexp(c, &exponent);
  // c < 2^exponent, so y begins above the root, and the iteration descends to the root.
  const int seventh = exponent >= 0 ? (exponent + 6) / 7 : -(-exponent / 7);
  double y = std::ldexp(1.0, seventh);
  for (int i = 0; i < 12; ++i) {
    const double y2 = y * y, y6 = y2 * y2 * y2, next = (6 * y + c / y6) / 7;
    if (next == y) break;
    y = next;
  }
  return std::sqrt(y);
}

}  // namespace resect
