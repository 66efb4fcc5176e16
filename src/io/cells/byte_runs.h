// Run-length coding of bytes and floats for files, the same on every machine.
//
// A run is its length (1 or more; seven bits a byte, lowest first, the top bit set on all bytes but
// the last), then the value: a byte, or four of an IEEE 754 number, lowest first.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace resect {

std::string toRuns(std::span<const std::uint8_t> values);
std::string toRuns(std::span<const float> values);

// Fills `values` and returns true; or returns false, having written nothing, if the bytes are not
// complete runs of exactly that many values.
bool fromRuns(std::string_view bytes, std::span<std::uint8_t> values);
bool fromRuns(std::string_view bytes, std::span<float> values);
// Number of values in the runs; -1 if they are incomplete. To be called before allocating memory.
std::int64_t countInRuns(std::string_view bytes, std::size_t bytesPerValue);

}  // namespace resect
