// Names for the labels of an image that contains no names: those of TotalSegmentator.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace resect {

// The number of a structure in images that TotalSegmentator 2 writes with all labels in one file
// (task "total"): 5 for "liver". `name` may be in upper or lower case; blanks and "-" in it count
// as "_". Nothing if there is no structure with that name. Source: Wasserthal et al. 2023,
// 10.1148/ryai.230024, and its class map.
std::optional<std::int64_t> totalSegmentatorLabel(std::string_view name);

// The name of the structure with the number `label`; empty if there is none.
std::string_view totalSegmentatorName(std::int64_t label);

}  // namespace resect
