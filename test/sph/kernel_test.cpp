#include "sph/kernel.h"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>

using namespace resect;

TEST_CASE("the kernel's shape equals the three corrected branches of the thesis") {
  for (double s = 0; s < 2.5; s += 0.01) {
    const double s2 = s * s, s3 = s2 * s, s4 = s3 * s;
    const double branch = s < 0.5   ? s4 / 4 - 5 * s2 / 8 + 115.0 / 192
                          : s < 1.5 ? -s4 / 6 + 5 * s3 / 6 - 5 * s2 / 4 + 5 * s / 24 + 55.0 / 96
                                    : std::pow(2.5 - s, 4) / 24;
    REQUIRE(kernelShape(s) == doctest::Approx(branch).epsilon(1e-12));
  }
}

TEST_CASE("the kernel and its slope are continuous where the branches meet") {
  for (double s : {0.5, 1.5, 2.5}) {
    const double e = 1e-9;
    CHECK(std::abs(kernelShape(s - e) - kernelShape(s + e)) < 1e-8);
    CHECK(std::abs(kernelShapeSlope(s - e) - kernelShapeSlope(s + e)) < 1e-8);
  }
  CHECK(kernelShape(2.5) == 0);
  CHECK(kernelShape(3) == 0);
}

TEST_CASE("the kernel's slope is the derivative of its shape") {
  for (double s = 0.05; s < 2.5; s += 0.1) {
    const double e = 1e-5;
    CHECK(kernelShapeSlope(s) ==
          doctest::Approx((kernelShape(s + e) - kernelShape(s - e)) / (2 * e)).epsilon(1e-6));
  }
}

TEST_CASE("the kernel integrates to one over space") {
  for (double h : {0.004, 1.0, 3.7}) {
    double sum = 0;
    const int n = 20000;
    const double dr = kKernelSupport * h / n;
    for (int i = 0; i < n; ++i) {
      const double r = (i + 0.5) * dr;
      sum += 4 * std::numbers::pi * r * r * kernel(r, h) * dr;
    }
    CHECK(sum == doctest::Approx(1).epsilon(1e-7));
  }
}

TEST_CASE(
    "on a full lattice with h equal to the spacing the sum of V W is one within 2e-4 at cell "
    "centres") {
  double sum = 0;
  for (int z = -3; z <= 3; ++z)
    for (int y = -3; y <= 3; ++y)
      for (int x = -3; x <= 3; ++x) sum += kernel(std::sqrt(double(x * x + y * y + z * z)), 1.0);
  CHECK(std::abs(sum - 1) < 2e-4);
}
