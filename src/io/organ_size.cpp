#include "io/organ_size.h"

#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace resect {

bool isOrganSized(const Aabb& box) {
  const double side = box.size().maxCoeff();
  return side >= 0.02 && side <= 1;
}

std::string plausibleUnit(const Aabb& box) {
  constexpr double kLiver = 0.2;  // m
  // Inches are rare, and too near to centimetres to be distinguished.
  constexpr std::array<std::pair<const char*, double>, 3> kUnits{
      {{"m", 1.0}, {"cm", 0.01}, {"mm", 0.001}}};
  const double side = box.size().maxCoeff();
  std::string best;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [name, metres] : kUnits) {
    const double share = side * metres / kLiver, off = std::max(share, 1 / share);
    if (off < least) least = off, best = name;
  }
  return best;
}

}  // namespace resect
