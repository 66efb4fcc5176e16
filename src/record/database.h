// A SQLite database file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "base/state/run_length.h"

struct sqlite3;
struct sqlite3_stmt;

namespace resect {

// All members throw Error in one sentence that begins with the file's name.
class Database {
 public:
  // Create: a new file; nothing may be there under its name, nor under the names that SQLite uses
  // beside it (-wal, -shm, -journal), since it would remove them. Copy: opens a private copy of a
  // file and of its -wal in a temporary folder. So what a file or its neighbours say makes SQLite
  // change nothing but the copy. Both take ordinary files only, and follow no link. GoOn: opens a
  // file that this program has made just now, for adding to it.
  enum class Mode { Create, Copy, GoOn };
  Database(const std::filesystem::path& path, Mode mode);
  Database();  // in memory, empty
  ~Database();
  Database(Database&&) = default;

  // Runs statements that return nothing.
  void run(const std::string& sql);
  // Writes the whole database as a new file; nothing may be there, nor beside it (Mode::Create).
  void copyTo(const std::filesystem::path& path);
  std::int64_t number(const std::string& sql);  // the first value of the first row; 0 without one
  const std::string& name() const { return name_; }
  // Throws the Error for the last failure.
  [[noreturn]] void fail() const;

 private:
  friend class Statement;
  struct Close {
    void operator()(sqlite3* db) const;
  };
  struct RemoveFolder {
    void operator()(std::filesystem::path* folder) const;
  };
  std::string name_;
  std::unique_ptr<std::filesystem::path, RemoveFolder> folder_;  // of the copy
  std::unique_ptr<sqlite3, Close> db_;
};

// A prepared statement, to be used again and again: bind, step to each row, read its columns.
// Columns and parameters are numbered from 0.
class Statement {
 public:
  Statement(Database& database, std::string_view sql);

  Statement& bind(int parameter, std::int64_t value);
  Statement& bind(int parameter, double value);
  Statement& bind(int parameter, std::string_view text);
  Statement& bind(int parameter, std::span<const std::byte> blob);
  // True: there is a row. False: no more; the statement is then ready for the next binding.
  bool step();
  void run() {  // for statements that return nothing
    while (step()) {
    }
  }

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
