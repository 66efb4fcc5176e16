// How are long arrays with much that is equal kept short? Words of 1, 2, 4 or 8 bytes as runs.
//
// A run is a head h (7 bits a byte, the lowest first, the eighth bit: there is more) of h / 4
// words. h % 4 tells which: 0 those that follow, 1 the one that follows again and again, 2 zeros, 3
// ones. Cost: some ns a word.
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
