// A range of array elements: `count` of them from `first` on.
#pragma once

#include <cstdint>

namespace resect {

struct IndexRange {
  std::int32_t first, count;
};

}  // namespace resect
