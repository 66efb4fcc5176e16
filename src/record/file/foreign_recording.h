// Reads a recording from an untrusted source.
//
// SQLite reads the file's bytes in a child process, inside the sandbox
// (formats/child/child_process.h). The child answers with the rows of all tables. The parent
// process checks the type of each value and inserts the rows into a database in memory, whose
// tables the parent has created. So only numbers, texts and blobs from the file reach the parent.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/progress.h"
#include "record/file/database.h"

namespace resect {

// What identifies a database as a recording: SQLite's application id, the version of the schema
// (user_version), and the definitions of its tables.
struct RecordingShape {
  struct Table {
    std::string name;
    std::vector<std::string> types;  // one per column: INTEGER, REAL, TEXT or BLOB
  };
  std::int64_t application = 0, version = 0;
  std::string definition;  // type, name and SQL text of each row of sqlite_master
  std::vector<Table> tables;
};
RecordingShape shapeOf(Database& own);

// Adds all rows of the recording at `path`, including those in its write-ahead log (-wal), to
// `own`. `own`: a recording whose tables are empty. Returns the errors that SQLite's integrity
// check finds in the file, in one line; empty if there are none. Throws Error if the file is not a
// recording, if its schema version or its tables differ from those of `own`, if file and log
// together have more than 1 GB, or if a value is of another type than its column. Throws Cancelled
// if `progress` returns false. Memory while it runs: about three times the file's size.
std::string addForeignRows(const std::filesystem::path& path, Database& own,
                           const Progress& progress = {});

// Decompresses bytes that zstd compressed. This is also done in a child process. size: number of
// bytes of the result, at most 1 GB. name: the recording's name in Errors. Throws Error if the
// bytes are damaged. Cost: the child process adds some ms.
Bytes unpackForeign(std::span<const std::byte> packed, std::int64_t size, const std::string& name);

// The two halves of addForeignRows(), declared here for tests. rowsOf() runs in the child and
// returns all rows as bytes. It throws Error if the result is larger than 1 MB plus four times the
// size of the recording. addRows() runs in the parent process: it adds the rows to `own` and
// returns the errors that the integrity check found.
std::string rowsOf(RecordingBytes& bytes, const RecordingShape& shape, const std::string& name);
std::string addRows(std::string_view rows, const RecordingShape& shape, Database& own);

// Appends the values of the present row to `to`. Before each value, appends the value's
// Statement::Kind.
void appendRow(std::string& to, const Statement& row);

}  // namespace resect
