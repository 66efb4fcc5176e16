// Checks the size of a TOML text before it is parsed: bytes, values, nesting, keys and texts.
//
// The parser recurses at each level of nesting and at each part of a key. So a file with too many
// brackets or dots would overflow the stack. Cost: one pass over the bytes. Nothing is allocated.
#pragma once

#include <string>
#include <string_view>

namespace resect {

inline constexpr std::size_t kMostTomlBytes = 16 << 20, kMostTomlValues = 1'000'000;
// Longest quoted text, and longest key or number, in bytes.
inline constexpr std::size_t kLongestTomlText = 10'000, kLongestTomlWord = 200;
// Most levels of brackets, and most parts of a key such as a.b.c.
inline constexpr int kDeepestToml = 30;

// Throws Error, with `name` and the line, if the text exceeds a limit. Brackets and dots in
// comments and in quoted texts do not count.
void requireParsable(std::string_view text, const std::string& name);

}  // namespace resect
