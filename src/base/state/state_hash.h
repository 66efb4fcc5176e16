// A 64-bit digest of a state's bytes. It is used to check whether two states are the same bit for
// bit.
//
// The digest is not cryptographic. Each 8-byte word is mixed in by the finaliser of splitmix64
// (Steele, Lea, Flood 2014). addBytes() pads the last word with zeros and does not add the number
// of bytes. addSpan() first adds the number of values.
#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>

namespace resect {

class StateHash {
 public:
  void addBytes(const void* data, std::size_t bytes);

  // Adds one number as a word.
  template <typename T>
  void add(const T& value) {
    static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
    std::uint64_t word = 0;
    std::memcpy(&word, &value, sizeof value);
    addWord(word);
  }
  // Only for elements without padding bytes (numbers, Eigen vectors of fixed size).
  template <typename T>
  void addSpan(std::span<const T> values) {
    add(values.size());
    addBytes(values.data(), values.size_bytes());
  }

  std::uint64_t value() const { return state_; }
  std::string hex() const;  // 16 digits

 private:
  void addWord(std::uint64_t word);
  std::uint64_t state_ = 0x9e3779b97f4a7c15u;
};

}  // namespace resect
