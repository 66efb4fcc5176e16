#include "sph/colour_values.h"

#include <algorithm>

#include "base/growth.h"

namespace resect {

void ColourValues::set(std::size_t cell, float value) {
  std::uint8_t level = 0;
  if (areLevels() && !toLevel(value, level)) {
    growTo(numbers_, levels_.size());
    std::transform(levels_.begin(), levels_.end(), numbers_.begin(),
                   [](std::uint8_t number) { return float(number) * kLevel; });
    levels_ = RawArray<std::uint8_t>();  // assigning {} would keep the memory
  }
  if (areLevels())
    levels_[cell] = level;
  else
    numbers_[cell] = value;
}

bool ColourValues::operator==(const ColourValues& other) const {
  if (size() != other.size()) return false;
  if (areLevels() && other.areLevels()) return levels_ == other.levels_;
  for (std::size_t cell = 0; cell < size(); ++cell)
    if ((*this)[cell] != other[cell]) return false;
  return true;
}

}  // namespace resect
