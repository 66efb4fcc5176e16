#include "io/cells/byte_runs.h"

#include <algorithm>
#include <bit>

namespace resect {
namespace {

constexpr std::uint64_t kLongest = std::uint64_t(1) << 32;  // run; more than any lattice has cells

std::uint32_t bitsOf(std::uint8_t value) { return value; }
std::uint32_t bitsOf(float value) { return std::bit_cast<std::uint32_t>(value); }
void take(std::uint32_t bits, std::uint8_t& value) { value = std::uint8_t(bits); }
void take(std::uint32_t bits, float& value) { value = std::bit_cast<float>(bits); }

template <typename Value>
std::string encoded(std::span<const Value> values) {
  std::string bytes;
  for (std::size_t i = 0; i < values.size();) {
    const std::uint32_t bits = bitsOf(values[i]);
    std::size_t end = i + 1;
    while (end < values.size() && bitsOf(values[end]) == bits) ++end;
    std::size_t length = end - i;
    for (; length >= 128; length >>= 7) bytes += char((length & 127) | 128);
    bytes += char(length);
    for (std::size_t b = 0; b < sizeof(Value); ++b) bytes += char(bits >> 8 * b & 255);
    i = end;
  }
  return bytes;
}

// visit(length, bits) for each run; false if the last one is incomplete, or a length is 0 or too
// large.
template <typename Visit>
bool visitRuns(std::string_view bytes, std::size_t width, Visit visit) {
  for (std::size_t at = 0; at < bytes.size();) {
    std::uint64_t length = 0;
    for (int shift = 0;; shift += 7) {
      if (at == bytes.size() || shift > 28) return false;
      const auto byte = std::uint8_t(bytes[at++]);
      length |= std::uint64_t(byte & 127) << shift;
      if (byte < 128) break;
    }
    if (length == 0 || length > kLongest || bytes.size() - at < width) return false;
    std::uint32_t bits = 0;
    for (std::size_t b = 0; b < width; ++b)
      bits |= std::uint32_t(std::uint8_t(bytes[at++])) << 8 * b;
    visit(std::size_t(length), bits);
  }
  return true;
}

template <typename Value>
bool decoded(std::string_view bytes, std::span<Value> values) {
  if (countInRuns(bytes, sizeof(Value)) != std::int64_t(values.size())) return false;
  std::size_t at = 0;
  return visitRuns(bytes, sizeof(Value), [&](std::size_t length, std::uint32_t bits) {
    Value value;
    take(bits, value);
    std::fill_n(values.begin() + std::ptrdiff_t(at), length, value);
    at += length;
  });
}

}  // namespace

std::string toRuns(std::span<const std::uint8_t> values) { return encoded(values); }
std::string toRuns(std::span<const float> values) { return encoded(values); }

bool fromRuns(std::string_view bytes, std::span<std::uint8_t> values) {
  return decoded(bytes, values);
}
bool fromRuns(std::string_view bytes, std::span<float> values) { return decoded(bytes, values); }

std::int64_t countInRuns(std::string_view bytes, std::size_t bytesPerValue) {
  std::int64_t count = 0;
  const bool whole = visitRuns(bytes, bytesPerValue, [&](std::size_t length, std::uint32_t) {
    count += std::int64_t(length);
  });
  return whole ? count : -1;
}

}  // namespace resect
