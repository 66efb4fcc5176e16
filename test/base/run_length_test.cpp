// Run-length coding: arrays are restored, damage is rejected.
#include <doctest/doctest.h>

#include <cstring>
#include <limits>

#include "base/random.h"
#include "base/state/run_length.h"
#include "support/sentence.h"

using namespace resect;
using test::isOneSentence;
using test::sentenceOf;

namespace {

Bytes unpacked(const Bytes& packed, std::size_t size, std::size_t word) {
  Bytes data;
  ByteReader from(packed);
  from.runs(data, size, word);
  CHECK(from.atEnd());
  return data;
}

// Arrays that runs might get wrong: of each length, equal, alternating, runs of 1 to 4, random.
std::vector<Bytes> awkwardArrays(std::size_t word, Random& random) {
  std::vector<Bytes> arrays;
  for (const int words : {0, 1, 2, 3, 4, 63, 64, 65, 127, 128, 8192, 20000})
    for (int kind = 0; kind < 6; ++kind) {
      Bytes array(std::size_t(words) * word);
      std::uint64_t value = random.next();
      for (int i = 0, left = 0; i < words; ++i) {
        if (kind == 1) value = ~value;
        if (kind == 2) value = random.next();
        if (kind == 3) value = std::uint64_t(random.below(2));
        if (kind == 4 && --left < 0) value = random.next(), left = random.below(4);
        if (kind == 5 && i == words - 1) value = ~value;  // another one at the end
        std::memcpy(array.data() + std::size_t(i) * word, &value, word);
      }
      arrays.push_back(std::move(array));
    }
  return arrays;
}

}  // namespace

TEST_CASE("runs of words give the array back, and one of equal words takes few bytes") {
  Random random(1);
  for (const std::size_t word : {1, 2, 4, 8}) {
    for (const Bytes& array : awkwardArrays(word, random)) {
      Bytes packed;
      appendRuns(packed, array, word);
      REQUIRE(unpacked(packed, array.size(), word) == array);
      CHECK(packed.size() <= array.size() + array.size() / word / 3 + 10);
    }
    Bytes packed;
    appendRuns(packed, Bytes(word * 1000000, std::byte(7)), word);
    CHECK(packed.size() < 16);
  }
}

TEST_CASE("numbers of every length come back") {
  Bytes bytes;
  std::vector<std::uint64_t> numbers{0, std::numeric_limits<std::uint64_t>::max()};
  for (int bit = 0; bit < 64; ++bit)
    for (const std::uint64_t less : {0, 1}) numbers.push_back((std::uint64_t(1) << bit) - less);
  for (const std::uint64_t number : numbers) appendNumber(bytes, number);
  ByteReader from(bytes);
  for (const std::uint64_t number : numbers) CHECK(from.number() == number);
  CHECK(from.atEnd());
}

TEST_CASE("runs that are longer than the array, empty or cut off are refused") {
  const auto refused = [](std::initializer_list<int> packed, std::size_t size, std::size_t word) {
    Bytes bytes;
    for (const int b : packed) bytes.push_back(std::byte(b));
    return isOneSentence(sentenceOf([&] { unpacked(bytes, size, word); }));
  };
  CHECK(refused({17, 1}, 3, 1));           // 4 words where 3 belong
  CHECK(refused({16, 1, 2, 3, 4}, 3, 1));  // the same, one by one
  CHECK(refused({0, 1}, 1, 1));            // a run of none
  CHECK(refused({13, 1}, 6, 2));           // half a word
  CHECK(refused({13, 1, 2}, 5, 2));        // 2.5 words
  CHECK(refused({12, 1, 2}, 3, 1));        // 2 of 3
  CHECK(refused({18}, 3, 1));              // 4 zeros where 3 belong
  CHECK(refused({0x87}, 3, 1));            // half a head
  CHECK(refused({255, 255, 255, 255, 255, 255, 255, 255, 255, 1, 5}, 8, 8));
  CHECK(refused({255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 1}, 8, 8));
  CHECK_FALSE(refused({13, 2}, 3, 1));
  CHECK_FALSE(refused({14}, 3, 1));
  CHECK_FALSE(refused({15}, 3, 1));
}

TEST_CASE("an array said to be far longer than its runs takes no memory") {
  const Bytes few{std::byte(7), std::byte(1)};
  Bytes data;
  ByteReader from(few);
  CHECK(isOneSentence(sentenceOf([&] { from.runs(data, std::size_t(1) << 31, 1); })));
  CHECK(data.capacity() < 1000);
}
