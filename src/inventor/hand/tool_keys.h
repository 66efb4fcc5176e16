// The keys with which the user takes instruments.
#pragma once

#include <string>
#include <string_view>

namespace resect {

// The keys of tools 0, 1, ...: the top row of a keyboard. Inventor's code of each key is its
// character.
inline constexpr std::string_view kToolKeys = "1234567890-=";

// The number of the tool that a key takes; -1 if it takes none.
inline int toolOfKey(int key) {
  const auto at = key > 0 && key < 128 ? kToolKeys.find(char(key)) : kToolKeys.npos;
  return at == kToolKeys.npos ? -1 : int(at);
}

// The tool's key as text; "" for a tool without a key.
inline std::string keyOfTool(std::size_t tool) {
  return tool < kToolKeys.size() ? std::string(1, kToolKeys[tool]) : "";
}

}  // namespace resect
