// Run-length coding of bytes and floats for files. It gives the same bytes on every machine.
//
// A run of equal values is stored as its length, then the value. The length is 1 or more. It is
// split into groups of seven bits, lowest first, and each group is stored in a byte. The top bit is
// set in each of these bytes but the last. The value is one byte, or the four bytes of an IEEE 754
// number, lowest first.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace resect {

std::string toRuns(std::span<const std::uint8_t> values);
std::string toRuns(std::span<const float> values);

// Decodes the bytes into `values` and returns true. If the bytes do not consist of complete runs
// with values.size() values in total, writes nothing and returns false.
bool fromRuns(std::string_view bytes, std::span<std::uint8_t> values);
bool fromRuns(std::string_view bytes, std::span<float> values);
// Number of values in the runs; -1 if a run is incomplete. Call this before allocating memory for
// the values.
std::int64_t countInRuns(std::string_view bytes, std::size_t bytesPerValue);

}  // namespace resect
