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

// Writes the cells of a row one after the other, then the end of the row. The decimal separator is
// a point in every locale. Numbers have enough digits to restore the same number.
class CsvWriter {
 public:
  explicit CsvWriter(std::ostream& out) : out_(out) {}

  // A spreadsheet may run a text as a formula if the text begins with = + - @, tab or carriage
  // return. Such a text may come from somebody else's recording. So an apostrophe is put before it.
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
  bool first_ = true;  // the next cell is the first cell of its row
};

// Writes a file, atomically. rows: a function that gives the rows to the CsvWriter. Throws Error if
// the file cannot be written.
void writeCsvFile(const std::filesystem::path& path, const std::function<void(CsvWriter&)>& rows);

}  // namespace resect
