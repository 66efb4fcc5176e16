#include "io/scenario/length.h"

#include <charconv>
#include <cmath>
#include <optional>

#include "base/error.h"
#include "operation/setting_ranges.h"

namespace resect {
namespace {

std::optional<double> unitFactor(std::string_view unit) {
  if (unit.empty() || unit == "m") return 1.0;
  if (unit == "mm") return 1e-3;
  if (unit == "cm") return 1e-2;
  if (unit == "um") return 1e-6;
  if (unit == "in" || unit == "inch") return 0.0254;
  return std::nullopt;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

}  // namespace

double parseLength(std::string_view text, std::string_view what) {
  const std::string_view all = trimmed(text);
  double number = 0;
  const auto [rest, ec] = std::from_chars(all.data(), all.data() + all.size(), number);
  const auto factor = unitFactor(trimmed(all.substr(std::size_t(rest - all.data()))));
  if (ec != std::errc() || !factor || !std::isfinite(number))
    throw usageError(
        "{} is \"{}\", which is no length; write a number with mm, cm, m, um or in, as 5mm", what,
        text);
  // Dividing keeps 5mm equal to 0.005 to the last bit.
  return *factor == 1e-3   ? number / 1e3
         : *factor == 1e-2 ? number / 1e2
         : *factor == 1e-6 ? number / 1e6
                           : number * *factor;
}

double parseUnit(std::string_view text, std::string_view what) {
  const std::string_view unit = trimmed(text);
  if (const auto factor = unitFactor(unit); factor && !unit.empty()) return *factor;
  double number = 0;
  const auto [rest, ec] = std::from_chars(unit.data(), unit.data() + unit.size(), number);
  if (ec != std::errc() || rest != unit.data() + unit.size() || !ranges::kUnit.holds(number))
    throw usageError(
        "{} is \"{}\", which is no unit; write mm, cm, m, um, in, or metres per unit as a number "
        "from {:g} to {:g}",
        what, text, ranges::kUnit.low, ranges::kUnit.high);
  return number;
}

std::string lengthText(double metres) {
  return std::abs(metres) < 0.1 ? fmt::format("{:.3g} mm", 1e3 * metres)
                                : fmt::format("{:.3g} m", metres);
}

}  // namespace resect
