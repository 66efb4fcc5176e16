// Reads a text file word by word or line by line, and makes Errors that name the line.
//
// Words are separated by spaces, tabs and line ends; NULs and Ctrl-Z, which some programs append,
// count as spaces. Lines end with LF, CR LF or CR. Numbers are read in all forms in which programs
// print them: ".5", "5.", "+5", "5E-1", Fortran's "5D-1", and for NaN "nan", "-nan(ind)" and
// "1.#QNAN".
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/error.h"
#include "base/vec.h"

namespace resect {

// Converts a word to a number; nothing if the word is not a number. A value too large for a double
// becomes infinite, a value too small becomes 0.
std::optional<double> numberOf(std::string_view word);
// The same for a whole number. Forms such as "3.0" and "1e+06", in which some programs print whole
// numbers, are accepted.
std::optional<std::int64_t> wholeNumberOf(std::string_view word);

inline constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";  // of UTF-8

std::string lowerCase(std::string_view text);  // ASCII letters only

std::string_view trimmed(std::string_view text);  // without the spaces round it
// The unsigned number in the four bytes from offset `at` on, the lowest byte first. These bytes
// must exist.
std::uint32_t littleEndian(std::string_view bytes, std::size_t at);

// The text of a file without the characters that some programs put before and after it: a byte
// order mark of UTF-8, blanks, empty lines, NULs and Ctrl-Z. Throws Error if the text is UTF-16.
std::string_view plainText(const std::string& path, std::string_view bytes);

class WordReader {
 public:
  // `path` is for messages. The reader keeps references to `path` and to the bytes, which must
  // outlive it. A byte order mark of UTF-8 is skipped.
  WordReader(const std::string& path, std::string_view bytes);

  std::string_view word();  // empty at the end
  std::string_view line();  // the rest of the line, without its end; empty at the end
  // Both read the next word and throw Error if it is not a number. what: what the word should be,
  // for the message, such as "a coordinate".
  double number(const char* what);
  std::int64_t wholeNumber(const char* what);
  Vec3 point();  // three numbers

  bool atEnd() const { return at_ >= bytes_.size(); }
  std::size_t place() const { return at_; }                 // offset of the next byte
  void goTo(std::size_t place) { at_ = read_ = place; }     // place <= number of bytes
  std::size_t left() const { return bytes_.size() - at_; }  // bytes not yet read

  std::string where() const;  // "path:line" of what was read last

  // "path:line: ...; export the file again"
  template <typename... Args>
  [[nodiscard]] Error fail(fmt::format_string<Args...> format, Args&&... args) const {
    return error("{}: {}; export the file again", where(),
                 fmt::format(format, std::forward<Args>(args)...));
  }
  // The Error about `word`, which stands where `what` should be. An empty word means that the file
  // ends early.
  [[nodiscard]] Error unexpected(std::string_view word, std::string_view what) const;

 private:
  const std::string& path_;
  std::string_view bytes_;
  std::size_t at_ = 0, read_ = 0;  // offset of the next byte; where the last read began
};

}  // namespace resect
