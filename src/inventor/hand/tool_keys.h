// The keys with which the user takes instruments.
#pragma once

#include <string>
#include <string_view>

namespace resect {

// The keys of tools 0, 1, 2 and so on, in this order. They are the top row of a keyboard.
// Inventor's code of each of these keys is the key's character.
inline constexpr std::string_view kToolKeys = "1234567890-=";

// The number of the tool that a key takes; -1 if the key takes no tool. key: Inventor's code of the
// key.
inline int toolOfKey(int key) {
  const auto at = key > 0 && key < 128 ? kToolKeys.find(char(key)) : kToolKeys.npos;
  return at == kToolKeys.npos ? -1 : int(at);
}

// The key of a tool, as text. Empty if the tool has no key.
inline std::string keyOfTool(std::size_t tool) {
  return tool < kToolKeys.size() ? std::string(1, kToolKeys[tool]) : "";
}

}  // namespace resect
