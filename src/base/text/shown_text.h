// Foreign text (from files, arguments, names) as one line that can be shown on a terminal or in a
// window as it is.
//
// Control characters, line ends, and Unicode characters that reverse or hide text become visible,
// for example as \n, \t, \x1b or \u202e. Bytes that are not valid UTF-8 become \xNN. Everything
// else is unchanged, also backslashes, since the result is for people to read and not for programs
// to parse.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace resect {

// The largest number of characters that are shown.
inline constexpr std::size_t kLongestShown = 200;       // of a name or a title
inline constexpr std::size_t kLongestSentence = 900;    // of a sentence that contains foreign text
inline constexpr std::size_t kLongestShownPath = 4200;  // of a path, or of a line of output

// If a text has more than `most` characters, only its beginning and its end are shown. Between them
// stands " ... ".
std::string shownText(std::string_view text, std::size_t most = kLongestShown);

// The same for the sentence of an error, a note or a fault.
inline std::string shownSentence(std::string_view text) {
  return shownText(text, kLongestSentence);
}

}  // namespace resect
