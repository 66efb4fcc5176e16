// Reads a recording that somebody else made.
//
// SQLite looks at its bytes in a child process in the sandbox (formats/child/child_process.h). The
// child answers with rows; this process checks each value and puts them into a database in memory
// that has its own tables. So nothing of the file but numbers, texts and blobs arrives here.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/progress.h"
#include "record/file/database.h"

namespace resect {

// What a recording is: its marks, and its tables to the letter.
struct RecordingShape {
  struct Table {
    std::string name;
    std::vector<std::string> types;  // of the columns: INTEGER, REAL, TEXT or BLOB
  };
  std::int64_t application = 0, version = 0;
  std::string definition;  // all that a database defines, as SQLite keeps it
  std::vector<Table> tables;
};
RecordingShape shapeOf(Database& own);

// Adds all rows of the recording at `path`, and of its log (-wal), to the empty tables of `own`.
// Returns what SQLite's own check of the file finds, in one line; empty: nothing. Throws Error if
// it is no recording, has other marks or tables than `own`, more than 1 GB, or a value of another
// type than its column, and Cancelled if `progress` says so. Memory: some three times the file
// meanwhile.
std::string addForeignRows(const std::filesystem::path& path, Database& own,
                           const Progress& progress = {});

// Unpacks what zstd packed, also in the sandbox. size: of the result, at most 1 GB. Throws Error if
// it is damaged. Cost: some ms more than unpacking it here.
Bytes unpackForeign(std::span<const std::byte> packed, std::int64_t size, const std::string& name);

// The two halves of addForeignRows(), for tests. In the child: all rows, at most four times as many
// bytes as the recording has and 1 MB. Here: adds them, and returns the finding.
std::string rowsOf(RecordingBytes& bytes, const RecordingShape& shape, const std::string& name);
std::string addRows(std::string_view rows, const RecordingShape& shape, Database& own);

// Adds the present row to `to`: its values, each with its kind.
void appendRow(std::string& to, const Statement& row);

}  // namespace resect
