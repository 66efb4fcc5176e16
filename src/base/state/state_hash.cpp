#include "base/state/state_hash.h"

#include <fmt/format.h>

namespace resect {

void StateHash::addWord(std::uint64_t word) {
  std::uint64_t z = state_ * 0x9fb21c651e98df25u + word + 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  state_ = z ^ (z >> 31);
}

void StateHash::addBytes(const void* data, std::size_t bytes) {
  const auto* p = static_cast<const unsigned char*>(data);
  for (; bytes >= 8; p += 8, bytes -= 8) {
    std::uint64_t word;
    std::memcpy(&word, p, 8);
    addWord(word);
  }
  if (bytes > 0) {
    std::uint64_t word = 0;
    std::memcpy(&word, p, bytes);
    addWord(word);
  }
}

std::string StateHash::hex() const { return fmt::format("{:016x}", state_); }

}  // namespace resect
