// The keys that take instruments in hand.
#pragma once

#include <string>
#include <string_view>

namespace resect {

// Of tools 0, 1, ...: the upper row of a keyboard. Inventor's codes of these keys are their
// characters.
inline constexpr std::string_view kToolKeys = "1234567890-=";

// The number of the tool that a key takes; -1: another key.
inline int toolOfKey(int key) {
  const auto at = key > 0 && key < 128 ? kToolKeys.find(char(key)) : kToolKeys.npos;
  return at == kToolKeys.npos ? -1 : int(at);
}

// For people; "" for a tool without a key.
inline std::string keyOfTool(std::size_t tool) {
  return tool < kToolKeys.size() ? std::string(1, kToolKeys[tool]) : "";
}

}  // namespace resect
