// The blood of an operation, as JSON and as lines of text.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "operation/blood/blood_summary.h"

namespace resect {

nlohmann::ordered_json toJson(const BloodSummary& summary);
std::string toText(const BloodSummary& summary);  // lines, each ends with a line break

}  // namespace resect
