// Which elements of an array? Those from `first` on.
#pragma once

#include <cstdint>

namespace resect {

struct IndexRange {
  std::int32_t first, count;
};

}  // namespace resect
