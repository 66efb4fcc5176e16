// The blood of an operation, as JSON and as lines of text.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "operation/blood/blood_summary.h"
#include "operation/ledger/segment_amounts.h"

namespace resect {

nlohmann::ordered_json toJson(const BloodSummary& summary);
std::string toText(const BloodSummary& summary);  // lines, each ends with a line break

nlohmann::ordered_json toJson(const std::vector<SegmentAmount>& segments);
// A line about Couinaud's segments of which 1 ml or more of tissue was separated from the body of
// the organ; "" if there are no such segments.
std::string toText(const std::vector<SegmentAmount>& segments);

}  // namespace resect
