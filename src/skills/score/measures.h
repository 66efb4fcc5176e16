// All measures of an attempt (operation/task/measure.h), for each instrument and for the whole
// attempt.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "skills/attempt/attempt.h"

namespace resect {

struct Measured {
  std::string measure;     // MeasureKind::id
  std::string instrument;  // name of the instrument; "": the whole attempt
  double value = 0;        // in the measure's unit
};

// Measures of vessels leave out vessels with a smaller diameter than this; a setting of ours.
inline constexpr double kNotableVessel = 0.002;  // m

// A volume of blood. If a vessel was cut before the operation began and has lost no more than this,
// the measure of open vessels leaves it out, since such a small injury need not be closed. A
// setting of ours.
inline constexpr double kBleeds = 1e-7;  // m^3

// Measures that cannot be computed are left out, for example forces if no tissue moves. The goal's
// own measures come from goalResult() (skills/score/goal_result.h) instead.
std::vector<Measured> measuresOf(const Attempt& attempt);

// The value of a measure in `all`; none if `all` does not contain the measure.
std::optional<double> valueOf(std::span<const Measured> all, std::string_view measure,
                              std::string_view instrument = "");

}  // namespace resect
