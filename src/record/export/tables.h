// Exports a recorded operation as tables, for spreadsheets.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "formats/export/csv_file.h"
#include "record/export/moments.h"

namespace resect {

// A kind of table. To add a kind, write a function that writes the table's header and rows, and add
// a line to the list in tables.cpp.
struct RecordingTable {
  std::string name;    // the argument of --table
  std::string oneRow;  // what a row contains, as text for users
  bool rated;          // whether ExportedPart::rate limits the number of rows
  // Writes the table and returns the number of its rows, without the header.
  std::int64_t (*write)(Replay&, const ExportedPart&, CsvWriter&, const Progress&);
};
std::span<const RecordingTable> recordingTables();

// Writes the table as CSV, atomically (io/output/atomic_file.h), and returns the number of its rows
// without the header. A recorded operation consists of branches (operation/live/branch.h). Memory:
// for the table `frames`, a few numbers; for each other table, all rows of one branch.
std::int64_t exportTable(Replay& replay, const ExportedPart& part, const RecordingTable& table,
                         const std::filesystem::path& path, const Progress& progress = {});

}  // namespace resect
