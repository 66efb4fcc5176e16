// How much of each cell of a lattice is tissue? Colour values in [0, 100].
//
// Held as 128ths of a full cell, levels, a byte each, while all values are such: an organ from a
// mesh has no others, for discretize() gives each cell the share of 4 x 4 x 4 samples inside,
// fitSurface() rounds what it corrects, and tools empty cells. As numbers levels are exact: 100/128
// has few digits. From the first other value on all are held as numbers. A large organ's cells so
// take a quarter of the waiting for memory.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/raw_array.h"

namespace resect {

constexpr float kLevel = 100.f / 128;  // the colour value of one
constexpr std::uint8_t kFullLevel = 128;

// value: in [0, 100]. False if it is not a whole number of levels.
inline bool toLevel(float value, std::uint8_t& level) {
  level = std::uint8_t(std::lround(value / kLevel));
  return float(level) * kLevel == value;
}

class ColourValues {
 public:
  ColourValues() = default;
  explicit ColourValues(std::size_t cells) : levels_(cells, 0) {}  // empty ones
  explicit ColourValues(RawArray<std::uint8_t> levels) : levels_(std::move(levels)) {}
  explicit ColourValues(RawArray<float> numbers) : numbers_(std::move(numbers)) {}

  std::size_t size() const { return areLevels() ? levels_.size() : numbers_.size(); }
  float operator[](std::size_t cell) const {
    return areLevels() ? float(levels_[cell]) * kLevel : numbers_[cell];
  }
  // value: in [0, 100]. The first one that is not a whole number of levels costs a pass over all
  // cells.
  void set(std::size_t cell, float value);

  bool areLevels() const { return numbers_.empty(); }
  // One of them holds the cells.
  std::span<const std::uint8_t> levels() const { return levels_; }
  std::span<const float> numbers() const { return numbers_; }

  // The same values, however they are held.
  bool operator==(const ColourValues& other) const;
  std::size_t bytes() const { return levels_.capacity() + numbers_.capacity() * sizeof(float); }

 private:
  RawArray<std::uint8_t> levels_;
  RawArray<float> numbers_;
};

}  // namespace resect
