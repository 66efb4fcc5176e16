// Run-length coding of arrays of words of 1, 2, 4 or 8 bytes, for saved states.
//
// A run is a head h, then data. h has 7 bits a byte, lowest first; the eighth bit is set on all
// bytes but the last. The run is h / 4 words long; h % 4 is its type: 0 literal words that follow,
// 1 one word that follows, repeated, 2 zeros, 3 ones. Cost: some ns a word.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace resect {

using Bytes = std::vector<std::byte>;

void appendNumber(Bytes& to, std::uint64_t number);  // 1 to 10 bytes

// word: 1, 2, 4 or 8; data: whole words.
void appendRuns(Bytes& to, std::span<const std::byte> data, std::size_t word);

// Reads what the two above wrote. Whatever does not fit, in length or in content, throws Error
// "the state is cut off or damaged".
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::byte> bytes) : rest_(bytes) {}
  std::uint64_t number();
  std::span<const std::byte> bytes(std::size_t count);
  // Exactly `bytes` bytes; appends to `to`.
  void runs(Bytes& to, std::size_t bytes, std::size_t word);
  bool atEnd() const { return rest_.empty(); }

 private:
  std::span<const std::byte> rest_;
};

[[noreturn]] void throwDamagedState();

}  // namespace resect
