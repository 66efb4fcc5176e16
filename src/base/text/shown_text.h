// Foreign text (from files, arguments, names) as one line that can be shown on a terminal or in a
// window as it is.
//
// Control characters, line ends, and marks that reverse or hide writing become visible: \n, \t,
// \x1b, \u202e. Bytes that are no UTF-8 become \xNN. All else stays, backslashes too: the result is
// to be read, not to be parsed.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace resect {

inline constexpr std::size_t kLongestShown = 200;     // characters: of a name or a title
inline constexpr std::size_t kLongestSentence = 900;  // of a sentence with foreign text in it
inline constexpr std::size_t kLongestShownPath = 4200;

// Of a text of more than `most` characters the beginning and the end are shown, with " ... "
// between them.
std::string shownText(std::string_view text, std::size_t most = kLongestShown);

// An error, a note or a fault.
inline std::string shownSentence(std::string_view text) {
  return shownText(text, kLongestSentence);
}

}  // namespace resect
