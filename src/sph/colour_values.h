// Colour values of a lattice's cells: the percentage of each cell that is tissue, 0 to 100.
//
// A value that is k * 100/128 with a whole number k has the level k. As long as all values have
// levels, only the levels are stored, in one byte each. All values of an organ that is made from a
// mesh have levels: discretize() counts 4 x 4 x 4 sample points per cell, fitSurface() rounds its
// corrections, and tools only set cells to 0. The value of a level is exact as a float, since
// 100/128 has few binary digits. When a value without a level is set, all values are converted to
// floats, and they remain floats. Levels need a quarter of the memory traffic of floats.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/raw_array.h"

namespace resect {

constexpr float kLevel = 100.f / 128;  // the colour value of one level
constexpr std::uint8_t kFullLevel = 128;

// Sets `level` to the level nearest to `value`, which is in [0, 100]. Returns false if `value` has
// no level.
inline bool toLevel(float value, std::uint8_t& level) {
  level = std::uint8_t(std::lround(value / kLevel));
  return float(level) * kLevel == value;
}

class ColourValues {
 public:
  ColourValues() = default;
  explicit ColourValues(std::size_t cells) : levels_(cells, 0) {}  // all values 0
  explicit ColourValues(RawArray<std::uint8_t> levels) : levels_(std::move(levels)) {}
  explicit ColourValues(RawArray<float> numbers) : numbers_(std::move(numbers)) {}

  std::size_t size() const { return areLevels() ? levels_.size() : numbers_.size(); }
  float operator[](std::size_t cell) const {
    return areLevels() ? float(levels_[cell]) * kLevel : numbers_[cell];
  }
  // value: in [0, 100]. The first value without a level costs a pass over all cells.
  void set(std::size_t cell, float value);

  bool areLevels() const { return numbers_.empty(); }
  // One of these two holds the values; the other is empty.
  std::span<const std::uint8_t> levels() const { return levels_; }
  std::span<const float> numbers() const { return numbers_; }

  // Whether the values are equal, however they are stored.
  bool operator==(const ColourValues& other) const;
  std::size_t bytes() const { return levels_.capacity() + numbers_.capacity() * sizeof(float); }

 private:
  RawArray<std::uint8_t> levels_;
  RawArray<float> numbers_;
};

}  // namespace resect
