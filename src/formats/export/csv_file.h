// Rows of text and numbers for spreadsheets: comma-separated values as in RFC 4180.
#pragma once

#include <fmt/format.h>

#include <concepts>
#include <ostream>
#include <string>
#include <string_view>

namespace resect {

// Writes cell after cell, then the row's end. Numbers have a decimal point in every locale, and as
// many digits as give the same number again.
class CsvWriter {
 public:
  explicit CsvWriter(std::ostream& out) : out_(out) {}

  // A text that a spreadsheet would take for a formula (it begins with = + - @, tab or carriage
  // return) gets an apostrophe before it: recordings come from strangers.
  CsvWriter& cell(std::string_view text);
  template <typename T>
  requires std::integral<T> || std::floating_point<T> CsvWriter& cell(T number) {
    return raw(fmt::format("{}", number));
  }
  CsvWriter& empty() { return raw(""); }
  template <typename... Cells>
  void row(const Cells&... cells) {
    (cell(cells), ...);
    end();
  }
  void end();

 private:
  CsvWriter& raw(std::string_view text);
  std::ostream& out_;
  bool first_ = true;  // in its row
};

}  // namespace resect
