// Run-length coding of arrays of words of 1, 2, 4 or 8 bytes, for saved states.
//
// A run is a whole number h, then data. h is written with 7 bits per byte, lowest first; the eighth
// bit is set on all bytes but the last. The run stands for h / 4 words (rounded down). h % 4 is its
// type: 0, these words follow; 1, one word follows and is repeated; 2, all words are 0; 3, all
// words are 1. Cost: some ns per word.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace resect {

using Bytes = std::vector<std::byte>;

void appendNumber(Bytes& to, std::uint64_t number);  // 1 to 10 bytes

// word: bytes per word, 1, 2, 4 or 8. data: whole words.
void appendRuns(Bytes& to, std::span<const std::byte> data, std::size_t word);

// Reads what appendNumber() and appendRuns() wrote. Throws Error "the state is cut off or damaged"
// if length or content does not fit.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::byte> bytes) : rest_(bytes) {}
  std::uint64_t number();
  std::span<const std::byte> bytes(std::size_t count);
  // Appends to `to` the words of the runs that follow: exactly `bytes` bytes.
  void runs(Bytes& to, std::size_t bytes, std::size_t word);
  bool atEnd() const { return rest_.empty(); }

 private:
  std::span<const std::byte> rest_;
};

[[noreturn]] void throwDamagedState();

}  // namespace resect
