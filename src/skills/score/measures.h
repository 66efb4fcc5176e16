// All measures of an attempt (operation/task/measure.h), of each instrument and of the whole.
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
  std::string instrument;  // its name; "": of the whole attempt
  double value = 0;        // in the measure's unit
};

// Vessels thinner than this are not counted one by one; a setting of ours.
inline constexpr double kNotableVessel = 0.002;  // m

// A vessel in a wound from the start that has lost less does not count as open: a nick in a vein
// that does not bleed is nothing to be closed. A setting of ours.
inline constexpr double kBleeds = 1e-7;  // m^3

// Measures that cannot be computed are left out: those of forces if no tissue moves, for example.
// Those of the goal come from goalResult() (skills/score/goal_result.h).
std::vector<Measured> measuresOf(const Attempt& attempt);

std::optional<double> valueOf(std::span<const Measured> all, std::string_view measure,
                              std::string_view instrument = "");

}  // namespace resect
