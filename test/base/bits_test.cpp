#include <doctest/doctest.h>

#include <array>
#include <limits>
#include <vector>

#include "base/bit_list.h"
#include "base/flag_bits.h"
#include "base/random.h"

using namespace resect;

TEST_CASE("the list of a word's bits is that found bit by bit") {
  Random random(1);
  for (int round = 0; round < 300; ++round) {
    std::uint64_t word = round == 0 ? 0 : round == 1 ? ~std::uint64_t(0) : random.next();
    for (int thin = 0; thin < round % 4; ++thin) word &= random.next();
    const unsigned first = 64 * unsigned(random.below(4));
    std::vector<std::uint8_t> expected;
    for (unsigned bit = 0; bit < 64; ++bit)
      if (word >> bit & 1) expected.push_back(std::uint8_t(first + bit));
    std::array<std::uint8_t, 64 + 8> list;
    const std::uint8_t* end = appendSetBits(word, first, list.data());
    REQUIRE(std::vector<std::uint8_t>(list.cbegin(), list.cbegin() + (end - list.data())) ==
            expected);
  }
}

TEST_CASE("64 comparisons as bits are those made one by one") {
  Random random(2);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (int round = 0; round < 100; ++round) {
    std::array<float, 64> values;
    for (float& v : values) {
      const auto kind = random.below(5);
      v = kind == 0 ? 50.f : kind == 1 ? nan : kind == 2 ? -0.f : float(random.uniform(0, 100));
    }
    const auto least = [](const FourValues& v) -> FourFlags { return v >= 50.f; };
    const auto other = [](const FourValues& v) -> FourFlags { return v != 0.f; };
    const std::uint64_t a = compared64(values.data(), least), b = compared64(values.data(), other);
    for (std::size_t i = 0; i < 64; ++i) {
      CHECK((a >> i & 1) == (values[i] >= 50.f));
      CHECK((b >> i & 1) == (values[i] != 0.f));
    }
  }
}
