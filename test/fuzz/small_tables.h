// Tables for the fuzz targets of recordings: small, with every kind of table and column that a
// recording has. The readers know no table by name.
#pragma once

#include "record/file/foreign_recording.h"

namespace resect::test {

// One database for all inputs, which is faster than a new one each.
struct SmallTables {
  Database own = Database::inMemory("the recording");
  RecordingShape shape;

  SmallTables() {
    own.run(R"(PRAGMA application_id = 1; PRAGMA user_version = 1;
CREATE TABLE meta (key TEXT PRIMARY KEY, value TEXT NOT NULL);
CREATE TABLE frames (branch INTEGER, time REAL NOT NULL, input BLOB NOT NULL, PRIMARY KEY (branch)) WITHOUT ROWID;
CREATE TABLE events (tool INTEGER, amount REAL, text TEXT);
)");
    shape = shapeOf(own);
  }
  // Adds the rows to empty tables.
  void add(std::string_view rows) {
    own.run("DELETE FROM meta; DELETE FROM frames; DELETE FROM events");
    try {
      addRows(rows, shape, own);
    } catch (...) {
      own.run("ROLLBACK");
      throw;
    }
  }
};

inline SmallTables& smallTables() {
  static SmallTables tables;
  return tables;
}

}  // namespace resect::test
