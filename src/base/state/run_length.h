// Run-length coding of arrays of words of 1, 2, 4 or 8 bytes, for saved states.
//
// The code is a series of runs. A run begins with a whole number h and stands for h / 4 words
// (rounded down). The type of the run is h % 4:
//
//   0: the words follow
//   1: one word follows; all words of the run are equal to it
//   2: nothing follows; all words are 0
//   3: nothing follows; all words are 1
//
// h is written with 7 bits per byte, the lowest bits first. The eighth bit of a byte is set if
// another byte of h follows. Cost: a few nanoseconds per word.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace resect {

using Bytes = std::vector<std::byte>;

void appendNumber(Bytes& to, std::uint64_t number);  // appends 1 to 10 bytes

// word: bytes per word, 1, 2, 4 or 8. data: a whole number of words.
void appendRuns(Bytes& to, std::span<const std::byte> data, std::size_t word);

// Reads what appendNumber() and appendRuns() wrote. Throws Error "the state is cut off or damaged"
// if bytes are missing or make no sense.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::byte> bytes) : rest_(bytes) {}
  std::uint64_t number();
  std::span<const std::byte> bytes(std::size_t count);  // the next `count` bytes
  // Unpacks the next runs and appends their words to `to`. `bytes`: total size of these words.
  // `word`: bytes per word.
  void runs(Bytes& to, std::size_t bytes, std::size_t word);
  bool atEnd() const { return rest_.empty(); }

 private:
  std::span<const std::byte> rest_;
};

[[noreturn]] void throwDamagedState();

}  // namespace resect
