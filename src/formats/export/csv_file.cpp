#include "formats/export/csv_file.h"

#include "io/output/atomic_file.h"

namespace resect {

CsvWriter& CsvWriter::raw(std::string_view text) {
  if (!first_) out_ << ',';
  first_ = false;
  out_ << text;
  return *this;
}

CsvWriter& CsvWriter::cell(std::string_view text) {
  std::string shown(text);
  if (!shown.empty() && std::string_view("=+-@\t\r").find(shown[0]) != std::string_view::npos)
    shown.insert(0, 1, '\'');
  if (shown.find_first_of(",\"\r\n") == std::string::npos) return raw(shown);
  std::string quoted = "\"";
  for (const char c : shown) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return raw(quoted + '"');
}

void CsvWriter::end() {
  out_ << "\r\n";
  first_ = true;
}

void writeCsvFile(const std::filesystem::path& path, const std::function<void(CsvWriter&)>& rows) {
  writeFileAtomically(path, [&](std::ostream& out) {
    CsvWriter csv(out);
    rows(csv);
  });
}

}  // namespace resect
