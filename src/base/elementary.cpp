#include "base/elementary.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace resect::math {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kHalfPi = 0x1.921fb54442d18p+0, kHalfPiLow = 0x1.1a62633145c07p-54;

// n!: exact as a double up to 22!, so that 1 / n! is rounded the same everywhere.
constexpr double factorial(int n) { return n < 2 ? 1 : n * factorial(n - 1); }

// sign^k / (first + step k)!
template <std::size_t N>
constexpr std::array<double, N> inverseFactorials(int first, int step, double sign) {
  std::array<double, N> c{};
  double s = 1;
  for (std::size_t k = 0; k < N; ++k, s *= sign) c[k] = s / factorial(first + step * int(k));
  return c;
}

template <std::size_t N>
double polynomial(const std::array<double, N>& c, double x) {
  double sum = c[N - 1];
  for (std::size_t k = N - 1; k-- > 0;) sum = sum * x + c[k];
  return sum;
}

// x = quarters * pi/2 + (high + low), |high| <= pi/4.
struct Reduced {
  std::int64_t quarters;
  double high, low;
};

Reduced reduced(double x) {
  // pi/2 in three parts; products of the first two with whole numbers below 2^20 are exact.
  constexpr double kFirst = 0x1.921fb544p+0, kSecond = 0x1.0b4611a6p-34,
                   kThird = 0x1.3198a2e037073p-69;
  const double n = std::nearbyint(x * 0x1.45f306dc9c883p-1);
  const double first = x - n * kFirst, second = n * kSecond;
  const double part = first - second;
  const double rest = ((first - part) - second) - n * kThird;
  const double high = part + rest;
  return {std::int64_t(n), high, (part - high) + rest};
}

double sinOf(const Reduced& r) {
  constexpr auto kSeries = inverseFactorials<8>(3, 2, -1);  // -(sin(x) - x) / x^3 in x^2
  const double square = r.high * r.high;
  const double correction =
      r.low * (1 - 0.5 * square) - r.high * square * polynomial(kSeries, square);
  return r.high + correction;
}

double cosOf(const Reduced& r) {
  constexpr auto kSeries = inverseFactorials<8>(4, 2, -1);  // (cos(x) - 1 + x^2 / 2) / x^4 in x^2
  const double square = r.high * r.high, half = 0.5 * square, coarse = 1 - half;
  const double correction = square * square * polynomial(kSeries, square) - r.high * r.low;
  return coarse + (((1 - coarse) - half) + correction);
}

double quarterTurned(const Reduced& r, std::int64_t quarters) {
  const double value = (quarters & 1) != 0 ? cosOf(r) : sinOf(r);
  return (quarters & 2) != 0 ? -value : value;
}

// atan of 0 <= x <= 1 as high + low.
struct Sum {
  double high, low;
};
Sum atanOf(double x) {
  // atan x = atan c + atan t, t = (x - c) / (1 + x c), with the nearest c of three: |t| < 0.21.
  constexpr double kCentre[] = {0, 0.40625, 1};
  constexpr Sum kAngle[] = {{0, 0},
                            {0x1.8b24d394a1b25p-2, 0x1.b6d0ba3748fa8p-56},
                            {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55}};
  const int part = x < 0.2 ? 0 : x < 0.66 ? 1 : 2;
  const double c = kCentre[part];
  const double t = (x - c) / (1 + x * c), square = t * t;
  constexpr std::array<double, 13> kSeries = [] {
    std::array<double, 13> s{};
    for (std::size_t k = 0; k < s.size(); ++k) s[k] = (k % 2 == 0 ? -1.0 : 1.0) / double(2 * k + 3);
    return s;
  }();
  const double correction = t * square * polynomial(kSeries, square) + kAngle[part].low;
  const double high = kAngle[part].high + t;
  return {high, ((kAngle[part].high - high) + t) + correction};
}

}  // namespace

double sin(double x) {
  if (!(std::abs(x) <= 1e6)) return kNaN;
  if (std::abs(x) < 1e-9) return x;
  const Reduced r = reduced(x);
  return quarterTurned(r, r.quarters);
}

double cos(double x) {
  if (!(std::abs(x) <= 1e6)) return kNaN;
  const Reduced r = reduced(x);
  return quarterTurned(r, r.quarters + 1);
}

double atan2(double y, double x) {
  if (std::isnan(x) || std::isnan(y)) return kNaN;
  const double right = std::abs(x), up = std::abs(y);
  Sum angle{0, 0};
  if (up > 0 && up <= right)
    angle = atanOf(std::isinf(up) ? 1 : up / right);
  else if (up > right) {
    angle = atanOf(right / up);
    const double high = kHalfPi - angle.high;
    angle = {high, ((kHalfPi - high) - angle.high) + (kHalfPiLow - angle.low)};
  }
  double turned = angle.high + angle.low;
  if (std::signbit(x)) turned = 2 * kHalfPi - angle.high + (2 * kHalfPiLow - angle.low);
  if (up == 0 && right == 0) turned = 0;
  return std::signbit(y) ? -turned : turned;
}

double acos(double x) {
  if (!(std::abs(x) <= 1)) return kNaN;
  // Twice the angle whose tangent is t = sqrt(below / above); what t lacks by its rounding is found
  // from the residual of t^2 above = below.
  const double c = std::abs(x), below = 1 - c, above = 1 + c, aboveLow = c - (above - 1);
  const double t = std::sqrt(below / above), square = t * t, product = square * above;
  const double residual = ((below - product) - std::fma(square, above, -product)) -
                          std::fma(t, t, -square) * above - square * aboveLow;
  Sum angle = atanOf(t);
  if (t > 0) angle.low += residual / (2 * t * above * (1 + square));
  if (x > 0) return 2 * (angle.high + angle.low);
  return 2 * (kHalfPi - angle.high + (kHalfPiLow - angle.low));
}

double exp(double x) {
  if (std::isnan(x)) return x;
  if (x > 709.78) return std::numeric_limits<double>::infinity();
  if (x < -708.39) return 0;
  constexpr double kLn2 = 0x1.62e42fefa2p-1, kLn2Low = 0x1.9ef35793c7673p-41;
  const double n = std::nearbyint(x * 0x1.71547652b82fep+0);
  const double high = x - n * kLn2, low = n * kLn2Low;
  const double r = high - low, rest = (high - r) - low;
  constexpr auto kSeries = inverseFactorials<13>(2, 1, 1);  // (exp(x) - 1 - x) / x^2
  const double value = 1 + (r + (r * r * polynomial(kSeries, r) + rest));
  // Two factors: 2^1024 is none.
  const int scale = int(n), half = scale / 2;
  const auto power = [](int e) { return std::bit_cast<double>(std::uint64_t(e + 1023) << 52); };
  return value * power(half) * power(scale - half);
}

double cbrt(double x) {
  if (x == 0 || !std::isfinite(x)) return x;
  double size = std::abs(x), scale = 1;
  if (size < 0x1p-900) size *= 0x1p+300, scale = 0x1p-100;
  if (size > 0x1p+900) size *= 0x1p-300, scale = 0x1p+100;
  // A third of the exponent, and then Halley: each step has three times as many right digits.
  double y =
      std::bit_cast<double>(std::bit_cast<std::uint64_t>(size) / 3 + (std::uint64_t(682) << 52));
  for (int step = 0; step < 3; ++step) {
    const double cube = y * y * y;
    y -= y * ((cube - size) / (2 * cube + size));
  }
  y -= (y * y * y - size) / (3 * y * y);
  return std::copysign(y * scale, x);
}

}  // namespace resect::math
