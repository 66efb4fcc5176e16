// How are long arrays kept in few bytes, the same on every machine? As runs: how often a value
// comes one after the other, then the value.
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

// Fills `values` and returns true; or returns false, having written nothing, when the bytes are not
// whole runs of so many values.
bool fromRuns(std::string_view bytes, std::span<std::uint8_t> values);
bool fromRuns(std::string_view bytes, std::span<float> values);
// How many values the runs hold; -1 when they are not whole. To be asked before memory is taken.
std::int64_t countInRuns(std::string_view bytes, std::size_t bytesPerValue);

}  // namespace resect
