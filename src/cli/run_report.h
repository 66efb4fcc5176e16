// Reports of a run as JSON, plot and text.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "formats/line_plot.h"
#include "operation/run.h"

namespace resect {

nlohmann::ordered_json toJson(const RunSummary& summary, const Scenario& scenario);

// Plots the force, N, on each instrument that touched tissue, over time, s.
LinePlot forcePlot(const RunSummary& summary, const Scenario& scenario);

// `files`: the files written, one line each.
std::string toText(const RunSummary& summary, const Scenario& scenario,
                   const std::vector<std::string>& files);

}  // namespace resect
