#include "io/length_unit.h"

#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "base/error.h"

namespace resect {
namespace {

constexpr std::array<std::pair<const char*, double>, 4> kUnits{
    {{"m", 1.0}, {"cm", 0.01}, {"mm", 0.001}, {"inch", 0.0254}}};

}  // namespace

double metresPerUnit(const std::string& unit) {
  for (const auto& [name, metres] : kUnits)
    if (unit == name) return metres;
  double factor = 0;
  const char* const last = unit.data() + unit.size();
  const auto [end, status] = std::from_chars(unit.data(), last, factor);
  if (status != std::errc() || end != last || !(factor > 0) || !std::isfinite(factor))
    throw usageError("'{}' is no unit; use mm, cm, m, inch or the number of metres in one unit",
                     unit);
  return factor;
}

std::string plausibleUnit(const Aabb& box) {
  constexpr double kLiver = 0.2;  // m
  const double side = box.size().maxCoeff();
  if (!(side > 0)) return "";
  std::string best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {  // inches are rare and too near to centimetres to be told
    const double off = std::abs(std::log(side * kUnits[i].second / kLiver));
    if (off < least) least = off, best = kUnits[i].first;
  }
  return best;
}

bool isOrganSized(const Aabb& box) {
  const double side = box.size().maxCoeff();
  return side >= 0.02 && side <= 1;
}

}  // namespace resect
