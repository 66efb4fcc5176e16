#include "io/organ_size.h"

#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "io/scenario/length.h"

namespace resect {

bool isOrganSized(const Aabb& box) {
  const double side = box.size().maxCoeff();
  return side >= 0.02 && side <= 1;
}

std::string plausibleUnit(const Aabb& box) {
  constexpr double kLiver = 0.2;  // m
  // Inches are rare, and too near to centimetres to be distinguished.
  constexpr std::array<std::pair<const char*, double>, 4> kUnits{
      {{"m", 1.0}, {"cm", 0.01}, {"mm", 0.001}, {"um", 1e-6}}};
  const double side = box.size().maxCoeff();
  std::string best;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [name, metres] : kUnits) {
    const double share = side * metres / kLiver, off = std::max(share, 1 / share);
    if (off < least) least = off, best = name;
  }
  return best;
}

std::string unitHint(const Aabb& box, double metresPerUnit) {
  if (isOrganSized(box)) return "";
  Aabb own = box;
  own.min /= metresPerUnit;
  own.max /= metresPerUnit;
  const std::string unit = plausibleUnit(own);
  if (unit.empty()) return "";
  const double metres = parseUnit(unit, "--unit");
  own.min *= metres;
  own.max *= metres;
  return isOrganSized(own) ? unit : "";
}

std::string sizeDoubt(const Aabb& box, double metresPerUnit) {
  if (isOrganSized(box)) return "";
  const double side = box.size().maxCoeff();
  const std::string longest =
      fmt::format("its longest side is {}, which is no organ's", lengthText(side));
  const std::string unit = unitHint(box, metresPerUnit);
  if (unit.empty()) return longest + "; scale it in the program that made it";
  return fmt::format("{}; in {} it would be {}: add --unit {}", longest, unit,
                     lengthText(side / metresPerUnit * parseUnit(unit, "--unit")), unit);
}

Error withDoubt(const Error& error, const std::string& doubt) {
  if (doubt.empty() || std::string_view(error.what()).ends_with(doubt)) return error;
  return Error(fmt::format("{}; {}", error.what(), doubt), error.status());
}

}  // namespace resect
