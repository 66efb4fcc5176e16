// In which order do the crossings of a column stand? By depth, entering first where equal.
#pragma once

#include <algorithm>

#include "collision/columns.h"

namespace resect {

inline bool before(const Crossing& a, const Crossing& b) {
  return a.depth < b.depth || (a.depth == b.depth && a.sign > b.sign);
}

inline void sortColumn(Crossing* first, Crossing* last) {
  if (last - first > 32) {
    std::sort(first, last, before);
    return;
  }
  for (Crossing* i = first; i < last; ++i) {
    const Crossing moved = *i;
    Crossing* j = i;
    for (; j > first && before(moved, j[-1]); --j) *j = j[-1];
    *j = moved;
  }
}

}  // namespace resect
