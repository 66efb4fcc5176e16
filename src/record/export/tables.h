// A recorded operation as tables, for spreadsheets.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "formats/export/csv_file.h"
#include "record/export/moments.h"

namespace resect {

// A kind of table. To add one: a function that writes its header and rows, and a line in the list
// in tables.cpp.
struct RecordingTable {
  std::string name;    // of --table
  std::string oneRow;  // what a row is, for people
  bool rated;          // whether ExportedPart::rate thins its rows
  std::int64_t (*write)(Replay&, const ExportedPart&, CsvWriter&, const Progress&);  // rows
};
std::span<const RecordingTable> recordingTables();

// Writes the table as CSV, atomically (io/atomic_file.h), and returns the number of its rows
// without the header. Memory: for `frames` a few numbers, for the others the recording's rows of
// one branch.
std::int64_t exportTable(Replay& replay, const ExportedPart& part, const RecordingTable& table,
                         const std::filesystem::path& path, const Progress& progress = {});

}  // namespace resect
