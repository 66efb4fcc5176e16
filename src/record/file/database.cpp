#include "record/file/database.h"

#include <sqlite3.h>

#include "base/error.h"

namespace resect {

namespace fs = std::filesystem;

void Database::Close::operator()(sqlite3* db) const { ::sqlite3_close(db); }
void Statement::Finish::operator()(sqlite3_stmt* statement) const { ::sqlite3_finalize(statement); }

namespace {

constexpr const char* kBeside[] = {"-wal", "-shm", "-journal"};

}  // namespace

void Database::requireNothingAt(const fs::path& path) {
  std::error_code ec;
  if (fs::exists(fs::symlink_status(path, ec)))
    throw error("{}: is there already, and a recording replaces nothing; choose another name",
                path.string());
  for (const char* end : kBeside)
    if (fs::exists(fs::symlink_status(path.string() + end, ec)))
      throw error("{}{}: is there already, and a recording would remove it; choose another name",
                  path.string(), end);
}

void Database::removeBeside(const fs::path& path) {
  std::error_code ec;
  for (const char* end : kBeside) fs::remove(path.string() + end, ec);
}

Database::Database(const fs::path& path, const std::string& name) : name_(name) {
  // The folder may be reached by links; the file itself may be none.
  std::error_code ec;
  const fs::path whole = fs::absolute(path), folder = fs::canonical(whole.parent_path(), ec);
  open((ec ? whole : folder / whole.filename()).string(), SQLITE_OPEN_CREATE | SQLITE_OPEN_NOFOLLOW,
       nullptr);
  ::sqlite3_busy_timeout(db_.get(), 2000);
}

Database Database::inMemory(const std::string& name) {
  Database database;
  database.name_ = name;
  database.open(":memory:", SQLITE_OPEN_CREATE, nullptr);
  return database;
}

Database::Database(RecordingBytes& bytes, const std::string& name) : name_(name) {
  open("recording", 0, memoryFiles(bytes));
  // Exclusive: the log's index is then not shared with other processes. Nothing is put into files.
  run("PRAGMA locking_mode = EXCLUSIVE; PRAGMA temp_store = MEMORY;");
}

void Database::open(const std::string& file, int flags, const char* files) {
  sqlite3* db = nullptr;
  const int result = ::sqlite3_open_v2(file.c_str(), &db,
                                       SQLITE_OPEN_READWRITE | SQLITE_OPEN_NOMUTEX | flags, files);
  db_.reset(db);
  if (result != SQLITE_OK) fail();
  // What a file holds is never run: no triggers or views of others, no functions, checked pages.
  ::sqlite3_db_config(db, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  ::sqlite3_db_config(db, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  ::sqlite3_db_config(db, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
  ::sqlite3_db_config(db, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
}

void Database::fail() const {
  const int code = db_ ? ::sqlite3_errcode(db_.get()) : SQLITE_NOMEM;
  if (code == SQLITE_NOTADB || code == SQLITE_CORRUPT)
    throw error("{}: is no recording, or is damaged; choose another file", name_);
  if (code == SQLITE_CONSTRAINT)
    throw error("{}: is damaged ({}); take an earlier copy of it", name_,
                ::sqlite3_errmsg(db_.get()));
  if (code == SQLITE_FULL) throw error("{}: the disk is full; free some space", name_);
  if (code == SQLITE_READONLY || code == SQLITE_CANTOPEN || code == SQLITE_PERM)
    throw error("{}: cannot be written; choose a folder you may write to", name_);
  throw error("{}: {}; check the file and the disk", name_,
              db_ ? ::sqlite3_errmsg(db_.get()) : "out of memory");
}

void Database::run(const std::string& sql) {
  if (::sqlite3_exec(db_.get(), sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) fail();
}

void Database::copyTo(const fs::path& path) {
  Statement(*this, "VACUUM INTO ?").bind(0, std::string_view(fs::absolute(path).string())).run();
}

std::int64_t Database::number(const std::string& sql) {
  Statement statement(*this, sql);
  return statement.step() ? statement.integer(0) : 0;
}

Statement::Statement(Database& database, std::string_view sql) : database_(database) {
  sqlite3_stmt* statement = nullptr;
  const int result =
      ::sqlite3_prepare_v2(database.db_.get(), sql.data(), int(sql.size()), &statement, nullptr);
  statement_.reset(statement);
  if (result != SQLITE_OK) database_.fail();
}

Statement& Statement::bind(int parameter, std::int64_t value) {
  if (::sqlite3_bind_int64(statement_.get(), parameter + 1, value) != SQLITE_OK) database_.fail();
  return *this;
}

Statement& Statement::bind(int parameter, double value) {
  if (::sqlite3_bind_double(statement_.get(), parameter + 1, value) != SQLITE_OK) database_.fail();
  return *this;
}

Statement& Statement::bind(int parameter, std::string_view text) {
  if (::sqlite3_bind_text(statement_.get(), parameter + 1, text.data(), int(text.size()),
                          SQLITE_TRANSIENT) != SQLITE_OK)
    database_.fail();
  return *this;
}

Statement& Statement::bind(int parameter, std::span<const std::byte> blob) {
  if (::sqlite3_bind_blob64(statement_.get(), parameter + 1,
                            blob.empty() ? "" : static_cast<const void*>(blob.data()), blob.size(),
                            SQLITE_TRANSIENT) != SQLITE_OK)
    database_.fail();
  return *this;
}

Statement& Statement::bindNothing(int parameter) {
  if (::sqlite3_bind_null(statement_.get(), parameter + 1) != SQLITE_OK) database_.fail();
  return *this;
}

bool Statement::step() {
  const int result = ::sqlite3_step(statement_.get());
  if (result == SQLITE_ROW) return true;
  if (result != SQLITE_DONE) {
    ::sqlite3_reset(statement_.get());
    database_.fail();
  }
  ::sqlite3_reset(statement_.get());
  return false;
}

static_assert(SQLITE_INTEGER == 1 && SQLITE_FLOAT == 2 && SQLITE_TEXT == 3 && SQLITE_BLOB == 4 &&
              SQLITE_NULL == 5);
Statement::Kind Statement::kind(int column) const {
  return Kind(::sqlite3_column_type(statement_.get(), column));
}
int Statement::columns() const { return ::sqlite3_column_count(statement_.get()); }

std::int64_t Statement::integer(int column) const {
  return ::sqlite3_column_int64(statement_.get(), column);
}
double Statement::real(int column) const {
  return ::sqlite3_column_double(statement_.get(), column);
}

std::string Statement::text(int column) const {
  const auto* text = ::sqlite3_column_text(statement_.get(), column);
  return text ? std::string(reinterpret_cast<const char*>(text),
                            std::size_t(::sqlite3_column_bytes(statement_.get(), column)))
              : std::string();
}

std::span<const std::byte> Statement::blob(int column) const {
  const void* data = ::sqlite3_column_blob(statement_.get(), column);
  return {static_cast<const std::byte*>(data),
          std::size_t(::sqlite3_column_bytes(statement_.get(), column))};
}

}  // namespace resect
