// Rows of text and numbers for spreadsheets: comma-separated values as in RFC 4180.
#pragma once

#include <fmt/format.h>

#include <concepts>
#include <filesystem>
#include <functional>
#include <ostream>
#include <string>
#include <string_view>

namespace resect {

// Writes the cells of a row one after the other, then the end of the row. Numbers have a decimal
// point in every locale, and enough digits to restore the same number.
class CsvWriter {
 public:
  explicit CsvWriter(std::ostream& out) : out_(out) {}

  // If a spreadsheet would take the text for a formula (it begins with = + - @, tab or carriage
  // return), an apostrophe is put before it. The text may come from somebody else's recording.
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
  bool first_ = true;  // the next cell is the first of its row
};

// Writes a file with these rows, atomically. Throws Error if it cannot be written.
void writeCsvFile(const std::filesystem::path& path, const std::function<void(CsvWriter&)>& rows);

}  // namespace resect
