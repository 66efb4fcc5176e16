// A scored attempt as JSON and as rows of CSV.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <ostream>
#include <span>

#include "formats/export/csv_file.h"
#include "skills/score/verdict.h"

namespace resect {

nlohmann::ordered_json toJson(const Scored& scored);

// One row per attempt: file, task, learner, level, verdict, then the whole attempt's measures, all
// of them in a fixed order.
void writeAttemptRows(CsvWriter& csv, std::span<const Scored> attempts);

// One row per frame and instrument in hand: time, instrument, pose, force, pedal.
void writeSampleRows(CsvWriter& csv, const Attempt& attempt);

// A number as it is printed: six significant digits, so that it is the same on every machine.
double printed(double value);

}  // namespace resect
