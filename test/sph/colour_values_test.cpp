// Colour values, stored as levels or as floats.
#include "sph/colour_values.h"

#include <doctest/doctest.h>

#include <utility>
#include <vector>

#include "base/flag_bits.h"
#include "base/random.h"

using namespace resect;

TEST_CASE("whole levels are held as bytes, and as the same numbers from the first other value on") {
  ColourValues values(200);
  CHECK(values.size() == 200);
  CHECK(values[199] == 0);
  for (int k = 0; k <= kFullLevel; ++k) {
    std::uint8_t level = 0;
    CHECK(toLevel(kLevel * float(k), level));
    CHECK(level == k);
    values.set(std::size_t(k), kLevel * float(k));
  }
  CHECK(values.areLevels());
  CHECK(values.levels().size() == 200);
  CHECK(values.levels()[kFullLevel] == kFullLevel);
  CHECK(values[kFullLevel] == 100);
  const ColourValues levels = values;
  std::uint8_t level = 0;
  for (const float other : {33.3f, 99.99f, 0.01f, 100.f / 129}) CHECK_FALSE(toLevel(other, level));
  values.set(7, 33.3f);
  CHECK_FALSE(values.areLevels());
  CHECK(values.numbers().size() == 200);
  CHECK(values[7] == 33.3f);
  CHECK_FALSE(values == levels);
  values.set(7, levels[7]);
  CHECK_FALSE(values.areLevels());
  CHECK(values == levels);
  CHECK(levels == values);
  CHECK_FALSE(values == ColourValues(199));
}

TEST_CASE("which of 64 bytes are not 0, and which have their upper bit set") {
  Random random(5);
  for (int k = 0; k < 100; ++k) {
    std::vector<std::uint8_t> bytes(64);
    std::uint64_t some = 0, upper = 0;
    for (std::size_t i = 0; i < 64; ++i) {
      bytes[i] = random.below(2) == 0 ? 0 : std::uint8_t(random.below(256));
      some |= std::uint64_t(bytes[i] != 0) << i;
      upper |= std::uint64_t(bytes[i] >= 128) << i;
    }
    CHECK(nonZero64(bytes.data()) == some);
    CHECK(upperBits64(bytes.data()) == upper);
  }
}
