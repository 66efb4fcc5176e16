#include "record/database.h"

#include <sqlite3.h>
#include <stdlib.h>

#include "base/error.h"

namespace resect {

namespace fs = std::filesystem;

void Database::Close::operator()(sqlite3* db) const { ::sqlite3_close(db); }
void Statement::Finish::operator()(sqlite3_stmt* statement) const { ::sqlite3_finalize(statement); }

void Database::RemoveFolder::operator()(fs::path* folder) const {
  std::error_code ec;
  fs::remove_all(*folder, ec);
  delete folder;
}

namespace {

constexpr const char* kBeside[] = {"-wal", "-shm", "-journal"};

void requireNothingThere(const fs::path& path) {
  std::error_code ec;
  if (fs::exists(fs::symlink_status(path, ec)))
    throw error("{}: is there already, and a recording replaces nothing; choose another name",
                path.string());
  for (const char* end : kBeside)
    if (fs::exists(fs::symlink_status(path.string() + end, ec)))
      throw error("{}{}: is there already, and a recording would remove it; choose another name",
                  path.string(), end);
}

void copyOrdinaryFile(const fs::path& from, const fs::path& to) {
  std::error_code ec;
  const fs::file_status status = fs::symlink_status(from, ec);
  if (!fs::exists(status)) throw error("{}: there is no such file; check the name", from.string());
  if (!fs::is_regular_file(status))
    throw error("{}: is no ordinary file; name the recording itself", from.string());
  if (!fs::copy_file(from, to, ec))
    throw error("{}: cannot be copied for reading: {}; check who may read it, and free some space",
                from.string(), ec.message());
}

// A folder of this user's own with copies of a recording and of its write-ahead log.
fs::path copied(const fs::path& path) {
  std::string folder = (fs::temp_directory_path() / "resect_recording_XXXXXX").string();
  if (!::mkdtemp(folder.data()))
    throw error("{}: there is no temporary folder to read it in; set TMPDIR", path.string());
  copyOrdinaryFile(path, fs::path(folder) / "copy");
  std::error_code ec;
  if (fs::exists(fs::symlink_status(path.string() + "-wal", ec)))
    copyOrdinaryFile(path.string() + "-wal", fs::path(folder) / "copy-wal");
  return folder;
}

}  // namespace

Database::Database(const fs::path& path, Mode mode) : name_(path.string()) {
  fs::path file = fs::absolute(path);
  if (mode == Mode::Create) {
    requireNothingThere(file);
  } else if (mode == Mode::Copy) {
    folder_.reset(new fs::path(copied(file)));
    file = *folder_ / "copy";
  }
  const int flags = SQLITE_OPEN_READWRITE | (mode == Mode::Create ? SQLITE_OPEN_CREATE : 0);
  sqlite3* db = nullptr;
  const int result = ::sqlite3_open_v2(file.c_str(), &db,
                                       flags | SQLITE_OPEN_NOFOLLOW | SQLITE_OPEN_NOMUTEX, nullptr);
  db_.reset(db);
  if (result != SQLITE_OK) fail();
  // What a file holds is never run: no triggers or views of others, no functions, checked pages.
  ::sqlite3_db_config(db, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  ::sqlite3_db_config(db, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  ::sqlite3_db_config(db, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
  ::sqlite3_db_config(db, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
  ::sqlite3_busy_timeout(db, 2000);
}

Database::Database() : name_("memory") {
  sqlite3* db = nullptr;
  const int result = ::sqlite3_open(":memory:", &db);
  db_.reset(db);
  if (result != SQLITE_OK) fail();
}

Database::~Database() = default;

void Database::fail() const {
  const int code = db_ ? ::sqlite3_errcode(db_.get()) : SQLITE_NOMEM;
  if (code == SQLITE_NOTADB || code == SQLITE_CORRUPT)
    throw error("{}: is no recording, or is damaged; choose another file", name_);
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
  requireNothingThere(path);
  try {
    Statement(*this, "VACUUM INTO ?").bind(0, std::string_view(fs::absolute(path).string())).run();
  } catch (const Error& e) {
    std::error_code ec;
    fs::remove(path, ec);
    throw error("{}: cannot be written ({}); free some space or choose another place",
                path.string(), e.what());
  }
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
