// The blood of an operation, as JSON and as lines of text.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "operation/blood/blood_summary.h"
#include "operation/ledger/segment_amounts.h"

namespace resect {

nlohmann::ordered_json toJson(const BloodSummary& summary);
std::string toText(const BloodSummary& summary);  // some lines; each ends with a line break

nlohmann::ordered_json toJson(const std::vector<SegmentAmount>& segments);
// A line about the Couinaud segments (regions of a liver) of which at least 1 ml has been separated
// from the organ's main part or removed. "" if there are no such segments.
std::string toText(const std::vector<SegmentAmount>& segments);

}  // namespace resect
