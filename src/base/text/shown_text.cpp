#include "base/text/shown_text.h"

#include <fmt/format.h>

#include <cstdint>
#include <vector>

namespace resect {
namespace {

constexpr std::uint32_t kNoCharacter = ~0u;

struct Character {
  std::uint32_t code = kNoCharacter;  // Unicode; kNoCharacter: a byte that is no UTF-8
  std::size_t bytes = 1;
};

// The first character of a text that is not empty: RFC 3629, without surrogates and needlessly long
// forms.
Character firstOf(std::string_view text) {
  const auto byte = [&](std::size_t i) { return std::uint32_t(std::uint8_t(text[i])); };
  const std::uint32_t lead = byte(0);
  if (lead < 0x80) return {lead, 1};
  const std::size_t bytes = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  if (lead < 0xc2 || lead > 0xf4 || text.size() < bytes) return {};
  std::uint32_t code = lead & (0xffu >> (bytes + 1));
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return {};
    code = code << 6 | (byte(i) & 0x3f);
  }
  constexpr std::uint32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
  if (code < kLeast[bytes] || code > 0x10ffff || (code >= 0xd800 && code < 0xe000)) return {};
  return {code, bytes};
}

// Controls, line and paragraph separators, directions of writing, and characters without width or
// ink.
bool isUnseen(std::uint32_t code) {
  const auto in = [&](std::uint32_t first, std::uint32_t last) {
    return code >= first && code <= last;
  };
  return code < 0x20 || in(0x7f, 0x9f) || code == 0xad || code == 0x61c || in(0x200b, 0x200f) ||
         in(0x2028, 0x202e) || in(0x2060, 0x206f) || code == 0xfeff || in(0xfff0, 0xfffb) ||
         in(0xe0000, 0xe0fff);
}

std::string shown(std::string_view text, const Character& character) {
  const std::uint32_t code = character.code;
  if (code == kNoCharacter) return fmt::format("\\x{:02x}", std::uint8_t(text[0]));
  if (code == '\n') return "\\n";
  if (code == '\r') return "\\r";
  if (code == '\t') return "\\t";
  if (!isUnseen(code)) return std::string(text.substr(0, character.bytes));
  return code < 0x80      ? fmt::format("\\x{:02x}", code)
         : code < 0x10000 ? fmt::format("\\u{:04x}", code)
                          : fmt::format("\\U{:08x}", code);
}

}  // namespace

std::string shownText(std::string_view text, std::size_t most) {
  constexpr std::string_view kGap = " ... ";
  const std::size_t head = most * 2 / 3,
                    tail = most > head + kGap.size() ? most - head - kGap.size() : 0;
  std::string all;
  std::vector<std::size_t> begins;  // of the characters in `all`; an escape counts as one
  while (!text.empty()) {
    const Character character = firstOf(text);
    begins.push_back(all.size());
    all += shown(text, character);
    text.remove_prefix(character.bytes);
  }
  if (begins.size() <= most) return all;
  return all.substr(0, begins[head]).append(kGap).append(all, begins[begins.size() - tail]);
}

}  // namespace resect
