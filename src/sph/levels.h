// Colour values as 128ths of a full cell, a byte each.
//
// An organ from a mesh has no others: discretize() gives each cell the share of 4 x 4 x 4 samples
// inside, fitSurface() rounds what it corrects to whole levels, tools empty cells. As numbers they
// are exact: 100/128 has few digits.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace resect {

constexpr float kLevel = 100.f / 128;  // the colour value of one
constexpr std::uint8_t kFullLevel = 128;

// value: in [0, 100]. False if it is not a whole number of levels.
inline bool toLevel(float value, std::uint8_t& level) {
  level = std::uint8_t(std::lround(value / kLevel));
  return float(level) * kLevel == value;
}

// The same of many. some, full: which of them hold anything, and which all they can, a bit each, in
// words of 64; bits beyond the last are 0. Up to the next multiple of 64 is written. False if one
// of the values is not a whole number of levels. With AVX2 where there is; the plain one for
// comparison.
bool toLevels(const float* values, std::size_t count, std::uint8_t* levels, std::uint64_t* some,
              std::uint64_t* full);
bool toLevelsPlainly(const float* values, std::size_t count, std::uint8_t* levels,
                     std::uint64_t* some, std::uint64_t* full);

}  // namespace resect
