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

// All members throw Error in one sentence that begins with the file's name.
class Database {
 public:
  // A file that this program has made just now, which may be empty. name: for messages.
  Database(const std::filesystem::path& path, const std::string& name);
  // Throws Error if something is there under that name, or under the names that SQLite uses beside
  // it (-wal, -shm, -journal), since it would remove them.
  static void requireNothingAt(const std::filesystem::path& path);
  // Removes what SQLite uses beside a file that is to be replaced: it would be joined to the new.
  static void removeBeside(const std::filesystem::path& path);
  // In memory, empty. name: for messages.
  static Database inMemory(const std::string& name);
  // The database of somebody else that `bytes` hold, its log joined; nothing that it defines is
  // run. For the child that reads it (record/file/foreign_recording.h).
  Database(RecordingBytes& bytes, const std::string& name);

  // Runs statements that return nothing.
  void run(const std::string& sql);
  // Writes the whole database into an empty file.
  void copyTo(const std::filesystem::path& path);
  std::int64_t number(const std::string& sql);  // the first value of the first row; 0 without one
  const std::string& name() const { return name_; }
  // Throws the Error for the last failure.
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

// A prepared statement, to be used again and again: bind, step to each row, read its columns.
// Columns and parameters are numbered from 0.
class Statement {
 public:
  Statement(Database& database, std::string_view sql);

  Statement& bind(int parameter, std::int64_t value);
  Statement& bind(int parameter, double value);
  Statement& bind(int parameter, std::string_view text);
  Statement& bind(int parameter, std::span<const std::byte> blob);
  Statement& bindNothing(int parameter);
  // True: there is a row. False: no more; the statement is then ready for the next binding.
  bool step();
  void run() {  // for statements that return nothing
    while (step()) {
    }
  }

  // Of the present row: what kind of value a column holds, which SQLite leaves to each row.
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
