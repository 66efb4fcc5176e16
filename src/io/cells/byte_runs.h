// Run-length coding of bytes and floats for files. It gives the same bytes on every machine.
//
// A run of equal values is stored as its length, followed by the value. The length is at least 1.
// The length is split into groups of seven bits, the lowest group first. Each group is stored in a
// byte of its own. The top bit of this byte is set if another group of the length follows. The
// value is stored as one byte, or as the four bytes of an IEEE 754 number, the lowest byte first.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace resect {

std::string toRuns(std::span<const std::uint8_t> values);
std::string toRuns(std::span<const float> values);

// Decodes the bytes into `values` and returns true. Writes nothing and returns false if a run is
// incomplete, or if the runs do not have values.size() values in total.
bool fromRuns(std::string_view bytes, std::span<std::uint8_t> values);
bool fromRuns(std::string_view bytes, std::span<float> values);
// Number of values in all runs; -1 if a run is incomplete or has an invalid length. Call this
// before allocating memory for the values.
std::int64_t countInRuns(std::string_view bytes, std::size_t bytesPerValue);

}  // namespace resect
