// A range of array elements: `count` elements, of which the first has the index `first`.
#pragma once

#include <cstdint>

namespace resect {

struct IndexRange {
  std::int32_t first, count;
};

}  // namespace resect
