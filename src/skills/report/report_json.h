// A scored attempt as JSON and as rows of CSV.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <ostream>
#include <span>

#include "formats/export/csv_file.h"
#include "skills/score/verdict.h"

namespace resect {

nlohmann::ordered_json toJson(const Scored& scored);

// One row per attempt: file, task, learner, level and verdict, then all measures of the whole
// attempt in a fixed order.
void writeAttemptRows(CsvWriter& csv, std::span<const Scored> attempts);

// One row per frame and instrument in hand: time, instrument, pose, force, pedal.
void writeSampleRows(CsvWriter& csv, const Attempt& attempt);

// The number rounded to six significant digits, since further digits can differ from machine to
// machine. Returns 0 if the number is not finite or if its absolute value is below 1e-9.
double printed(double value);

}  // namespace resect
