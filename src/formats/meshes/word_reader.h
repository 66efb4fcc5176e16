// Reads a text file word by word or line by line. Its Errors name the line of the file.
//
// Words are separated by spaces, tabs and line ends. NUL and Ctrl-Z count as spaces, since some
// programs append them. Lines end with LF, CR LF or CR. Numbers are read in all forms in which
// programs print them: ".5", "5.", "+5", "5E-1", Fortran's "5D-1", and for NaN "nan", "-nan(ind)"
// and "1.#QNAN".
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/error.h"
#include "base/vec.h"

namespace resect {

// The number that a word stands for. Returns nothing if the word is not a number. If the number is
// too large for a double, the result is infinite. If the number is too near to 0 for a double, the
// result is 0.
std::optional<double> numberOf(std::string_view word);
// The whole number that a word stands for. Returns nothing if the word is not a whole number. Forms
// such as "3.0" and "1e+06" are accepted, since some programs print whole numbers in this way.
std::optional<std::int64_t> wholeNumberOf(std::string_view word);

inline constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";  // for UTF-8

std::string lowerCase(std::string_view text);  // changes only ASCII letters

std::string_view trimmed(std::string_view text);  // without spaces at its start and end
// The unsigned number in four bytes, with the lowest byte first. at: offset of the first of these
// bytes. All four bytes must exist.
std::uint32_t littleEndian(std::string_view bytes, std::size_t at);

// The text of a file without the characters that some programs put at its start and end: a byte
// order mark of UTF-8, blanks, empty lines, NULs and Ctrl-Z. Throws Error if the text is UTF-16.
std::string_view plainText(const std::string& path, std::string_view bytes);

class WordReader {
 public:
  // `path` is for messages. The reader keeps references to `path` and to the bytes, so both must
  // outlive the reader. A byte order mark of UTF-8 is skipped.
  WordReader(const std::string& path, std::string_view bytes);

  // The next word. Empty if no word is left.
  std::string_view word();
  // The rest of the line, without its line end. Empty at the end of the bytes.
  std::string_view line();
  // Both functions read the next word. number() throws Error if the word is not a number, and
  // wholeNumber() if the word is not a whole number. what: tells in the message what the word
  // should be, such as "a coordinate".
  double number(const char* what);
  std::int64_t wholeNumber(const char* what);
  Vec3 point();  // reads three numbers

  bool atEnd() const { return at_ >= bytes_.size(); }
  std::size_t place() const { return at_; }                 // offset of the next byte
  void goTo(std::size_t place) { at_ = read_ = place; }     // place: at most the number of bytes
  std::size_t left() const { return bytes_.size() - at_; }  // bytes not yet read

  std::string where() const;  // "path:line", with the line at which the last read began

  // The Error "path:line: ...; export the file again".
  template <typename... Args>
  [[nodiscard]] Error fail(fmt::format_string<Args...> format, Args&&... args) const {
    return error("{}: {}; export the file again", where(),
                 fmt::format(format, std::forward<Args>(args)...));
  }
  // The Error that says that the file has `word` where `what` should be. If `word` is empty, the
  // Error says that the file ends early.
  [[nodiscard]] Error unexpected(std::string_view word, std::string_view what) const;

 private:
  const std::string& path_;
  std::string_view bytes_;
  // Offsets: at_ of the next byte, read_ of the first byte of the last read.
  std::size_t at_ = 0, read_ = 0;
};

}  // namespace resect
