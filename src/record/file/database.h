// A SQLite database.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "base/state/run_length.h"
#include "record/file/memory_files.h"

struct sqlite3;
struct sqlite3_stmt;

namespace resect {

// Any member function that fails throws an Error whose message begins with the file's name.
class Database {
 public:
  // Opens a database file that this program has written itself. If the file is empty or missing,
  // the database is empty. Fails if `path` is a symbolic link. name: the file's name in messages.
  Database(const std::filesystem::path& path, const std::string& name);
  // Throws Error if a file exists at `path`, or at `path` plus -wal, -shm or -journal. SQLite uses
  // these three names for files beside the database, and would remove a file that has such a name.
  static void requireNothingAt(const std::filesystem::path& path);
  // Removes the files named `path` plus -wal, -shm or -journal. To be called before the database
  // file at `path` is replaced, since SQLite would take these files for files of the new database.
  static void removeBeside(const std::filesystem::path& path);
  // An empty database in memory. name: used in messages.
  static Database inMemory(const std::string& name);
  // Opens a database from an untrusted source. `bytes` has the bytes of the database file and of
  // its write-ahead log. SQLite applies the log. No trigger, view or function of the database's
  // schema is run. Used in the child process that reads such files
  // (record/file/foreign_recording.h).
  Database(RecordingBytes& bytes, const std::string& name);

  // Runs statements that return nothing.
  void run(const std::string& sql);
  // Writes the whole database into the file at `path`, which must be empty.
  void copyTo(const std::filesystem::path& path);
  // Runs a query. Returns the first value in the first row of the result, or 0 if the result has no
  // row.
  std::int64_t number(const std::string& sql);
  const std::string& name() const { return name_; }
  // Throws an Error that describes the last failure of SQLite.
  [[noreturn]] void fail() const;

 private:
  friend class Statement;
  Database() = default;
  void open(const std::string& file, int flags, const char* files);
  struct Close {
    void operator()(sqlite3* db) const;
  };
  std::string name_;
  std::unique_ptr<sqlite3, Close> db_;
};

// A prepared statement, which can be used many times. For each use, bind its parameters, then call
// step() for each row and read the row's columns. Columns and parameters are numbered from 0.
class Statement {
 public:
  Statement(Database& database, std::string_view sql);

  Statement& bind(int parameter, std::int64_t value);
  Statement& bind(int parameter, double value);
  Statement& bind(int parameter, std::string_view text);
  Statement& bind(int parameter, std::span<const std::byte> blob);
  // Binds NULL.
  Statement& bindNothing(int parameter);
  // Goes to the next row. If there is no next row, returns false; the statement can then be bound
  // again.
  bool step();
  void run() {  // for statements that return nothing
    while (step()) {
    }
  }

  // The type of the present row's value in a column. In SQLite each value has its own type.
  enum class Kind : char { Integer = 1, Real, Text, Blob, Nothing };
  Kind kind(int column) const;
  int columns() const;
  std::int64_t integer(int column) const;
  double real(int column) const;
  std::string text(int column) const;
  std::span<const std::byte> blob(int column) const;  // valid until the next step()

 private:
  struct Finish {
    void operator()(sqlite3_stmt* statement) const;
  };
  Database& database_;
  std::unique_ptr<sqlite3_stmt, Finish> statement_;
};

}  // namespace resect
