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
  // Create: replaces a file that is there. Open: read-only if it may not be written.
  enum class Mode { Create, Open };
  Database(const std::filesystem::path& path, Mode mode);
  ~Database();
  Database(Database&&) = default;

  // Runs statements that return nothing.
  void run(const std::string& sql);
  std::int64_t number(const std::string& sql);  // the first value of the first row; 0 without one
  const std::string& name() const { return name_; }
  // Throws the Error for the last failure.
  [[noreturn]] void fail() const;

 private:
  friend class Statement;
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
