// Names that the labels of an image without names may have.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace resect {

// The number of a structure in images that TotalSegmentator 2 writes with all labels in one file
// (task "total"): 5 for "liver". Any case; blanks and "-" count as "_". Nothing if there is no
// structure with that name. Source: Wasserthal et al. 2023, 10.1148/ryai.230024, and its class map.
std::optional<std::int64_t> totalSegmentatorLabel(std::string_view name);

// The name of that number; empty if there is none.
std::string_view totalSegmentatorName(std::int64_t label);

}  // namespace resect
