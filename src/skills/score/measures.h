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

// Measures that cannot be computed are left out: those of forces if no tissue moves, for example.
// Those of the goal come from goalResult() (skills/score/goal_result.h).
std::vector<Measured> measuresOf(const Attempt& attempt);

std::optional<double> valueOf(std::span<const Measured> all, std::string_view measure,
                              std::string_view instrument = "");

// Grade of bleeding by its rate, m^3/s: 0 to 4, at 1, 5, 10 and 50 ml/min (VIBe; Lewis et al. 2017,
// 10.1186/s12893-020-00874-w). Surgeons differ by one grade.
int vibeGrade(double rate);

}  // namespace resect
