// Reports of a run as JSON, plot and text.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "formats/line_plot.h"
#include "operation/run.h"

namespace resect {

nlohmann::ordered_json toJson(const RunSummary& summary, const Scenario& scenario);

// One curve for each instrument on which a force acted: the force on the instrument, N, over time,
// s. Without elastic tissue no force is computed, and there are no curves.
LinePlot forcePlot(const RunSummary& summary, const Scenario& scenario);

// A summary for people. `files`: names of the files that were written; each name gets a line.
std::string toText(const RunSummary& summary, const Scenario& scenario,
                   const std::vector<std::string>& files);

}  // namespace resect
