// The names that TotalSegmentator, a program that segments scans, gives to labels. They are used
// for images that contain no names.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace resect {

// The number of the structure with the name `name`, such as 5 for "liver". The numbers are those of
// images that TotalSegmentator 2 writes with all labels in one file (task "total"). `name` may be
// in upper or lower case. A blank or "-" in `name` counts as "_". Returns nothing if no structure
// has that name. Sources: Wasserthal et al. 2023, 10.1148/ryai.230024; the class map of
// TotalSegmentator.
std::optional<std::int64_t> totalSegmentatorLabel(std::string_view name);

// The name of the structure with the number `label`. Empty if no structure has that number.
std::string_view totalSegmentatorName(std::int64_t label);

}  // namespace resect
