#include "record/file/foreign_recording.h"

#include <fmt/format.h>
#include <zstd.h>

#include <algorithm>
#include <cstring>

#include "base/error.h"
#include "formats/child/child_process.h"
#include "formats/child/foreign_file.h"
#include "record/file/recording_file.h"

namespace resect {
namespace {

namespace fs = std::filesystem;
using Kind = Statement::Kind;

constexpr std::size_t kMegabyte = std::size_t(1) << 20;
constexpr char kRow = 1, kEnd = 0;

std::size_t mostRowBytes(std::size_t recording) { return 4 * recording + kMegabyte; }

ChildLimits limitsFor(std::size_t bytes) {
  ChildLimits limits;
  limits.cpuSeconds = 10 + double(bytes) / double(4 * kMegabyte);
  limits.wallSeconds = 4 * limits.cpuSeconds;
  limits.memoryBytes = 256 * kMegabyte + 8 * bytes;
  limits.answerBytes = mostRowBytes(bytes);
  limits.ifTooLarge = limits.ifDamaged = "take an earlier copy of it";
  return limits;
}

RecordingBytes readBytes(const fs::path& path) {
  RecordingBytes bytes{readForeignFile(path, kLargestRecording, Links::Refused), {}};
  const fs::path log = path.string() + "-wal";
  std::error_code ec;
  if (fs::exists(fs::symlink_status(log, ec)))
    bytes.log = readForeignFile(log, kLargestRecording - bytes.file.size(), Links::Refused);
  return bytes;
}

std::string definitionOf(Database& database) {
  Statement rows(database,
                 "SELECT type || name || coalesce(sql, '') FROM sqlite_master ORDER BY name");
  std::string all;
  while (rows.step()) all += rows.text(0) + "\n";
  return all;
}

std::string ownCheck(Database& database) {
  Statement check(database, "PRAGMA integrity_check(1)");
  std::string found = check.step() ? check.text(0) : "";
  std::ranges::replace(found, '\n', ' ');
  return found == "ok" ? "" : found;
}

template <typename T>
void appendPlain(std::string& to, const T& value) {
  to.append(reinterpret_cast<const char*>(&value), sizeof value);
}

void appendText(std::string& to, std::string_view text) {
  appendPlain(to, std::uint64_t(text.size()));
  to += text;
}

std::string_view textOf(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// Takes the child's answer apart. It is not trusted: the file may have taken over the child.
class RowReader {
 public:
  RowReader(std::string_view rows, const std::string& name) : rest_(rows), name_(name) {}

  std::string_view raw(std::size_t size) {
    if (size > rest_.size()) damaged();
    const std::string_view taken = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return taken;
  }
  template <typename T>
  T plain() {
    T value;
    std::memcpy(&value, raw(sizeof value).data(), sizeof value);
    return value;
  }
  std::string_view text() { return raw(plain<std::uint64_t>()); }
  bool row() {
    const char mark = plain<char>();
    if (mark != kRow && mark != kEnd) damaged();
    return mark == kRow;
  }
  // The next value, which goes into a column of that type.
  void value(const std::string& type, Statement& insert, int column) {
    const auto kind = plain<Kind>();
    if (kind == Kind::Nothing)
      insert.bindNothing(column);
    else if (kind == Kind::Integer && type == "INTEGER")
      insert.bind(column, plain<std::int64_t>());
    else if (kind == Kind::Real && type == "REAL")
      insert.bind(column, plain<double>());
    else if (kind == Kind::Text && type == "TEXT")
      insert.bind(column, text());
    else if (kind == Kind::Blob && type == "BLOB")
      insert.bind(column, std::as_bytes(std::span(text())));
    else
      damaged();
  }
  void end() const {
    if (!rest_.empty()) damaged();
  }

 private:
  [[noreturn]] void damaged() const {
    throw error("{}: holds a value that a recording has not; take an earlier copy of it", name_);
  }
  std::string_view rest_;
  const std::string& name_;
};

std::string unpacked(std::span<const std::byte> packed, std::size_t size, const std::string& name) {
  std::string out;
  if (::ZSTD_getFrameContentSize(packed.data(), packed.size()) == size) {
    out.resize(size);
    if (::ZSTD_decompress(out.data(), size, packed.data(), packed.size()) == size) return out;
  }
  throw error("{}: a key state in it is damaged; take an earlier copy of it", name);
}

}  // namespace

RecordingShape shapeOf(Database& own) {
  RecordingShape shape{own.number("PRAGMA application_id"),
                       own.number("PRAGMA user_version"),
                       definitionOf(own),
                       {}};
  Statement tables(own, "SELECT name FROM sqlite_master WHERE type = 'table' ORDER BY name");
  while (tables.step()) {
    RecordingShape::Table table{tables.text(0), {}};
    Statement columns(own, fmt::format("PRAGMA table_info({})", table.name));
    while (columns.step()) table.types.push_back(columns.text(2));
    shape.tables.push_back(std::move(table));
  }
  return shape;
}

void appendRow(std::string& to, const Statement& row) {
  for (int c = 0; c < row.columns(); ++c) {
    const Kind kind = row.kind(c);
    appendPlain(to, kind);
    if (kind == Kind::Integer) appendPlain(to, row.integer(c));
    if (kind == Kind::Real) appendPlain(to, row.real(c));
    if (kind == Kind::Text) appendText(to, row.text(c));
    if (kind == Kind::Blob) appendText(to, textOf(row.blob(c)));
  }
}

std::string rowsOf(RecordingBytes& bytes, const RecordingShape& shape, const std::string& name) {
  const std::size_t size = bytes.file.size() + bytes.log.size();
  Database database(bytes, name);
  if (database.number("PRAGMA application_id") != shape.application)
    throw error("{}: is no recording of Resect; choose a .resect file", name);
  if (const std::int64_t version = database.number("PRAGMA user_version"); version != shape.version)
    throw error("{}: has version {} of the schema, and this program reads version {}; use {}", name,
                version, shape.version,
                version > shape.version ? "a newer Resect" : "the Resect that recorded it");
  if (definitionOf(database) != shape.definition)
    throw error("{}: its tables are not those of a recording; choose another file", name);
  std::string rows;
  rows.reserve(size + size / 4);
  appendText(rows, ownCheck(database));
  for (const RecordingShape::Table& table : shape.tables) {
    Statement all(database, fmt::format("SELECT * FROM {}", table.name));
    while (all.step()) {
      rows += kRow;
      appendRow(rows, all);
      // Rows of a damaged file may share pages, and so be far larger than the file.
      if (rows.size() > mostRowBytes(size))
        throw error("{}: its rows are larger than the file; take an earlier copy of it", name);
    }
    rows += kEnd;
  }
  return rows;
}

std::string addRows(std::string_view rows, const RecordingShape& shape, Database& own) {
  RowReader from(rows, own.name());
  std::string found(from.text());
  own.run("BEGIN");
  for (const RecordingShape::Table& table : shape.tables) {
    std::string places;
    for (std::size_t c = 0; c < table.types.size(); ++c) places += c == 0 ? "?" : ", ?";
    Statement insert(own, fmt::format("INSERT INTO {} VALUES ({})", table.name, places));
    while (from.row()) {
      for (std::size_t c = 0; c < table.types.size(); ++c)
        from.value(table.types[c], insert, int(c));
      insert.run();
    }
  }
  from.end();
  own.run("COMMIT");
  return found;
}

std::string addForeignRows(const fs::path& path, Database& own, const Progress& progress) {
  const RecordingShape shape = shapeOf(own);
  std::string rows;
  {
    RecordingBytes bytes = readBytes(path);
    rows = runInChild(
        own.name(), limitsFor(bytes.file.size() + bytes.log.size()),
        [&] { return rowsOf(bytes, shape, own.name()); }, [&] { report(progress, -1); },
        prepareSqliteInChild);
  }
  return addRows(rows, shape, own);
}

Bytes unpackForeign(std::span<const std::byte> packed, std::int64_t size, const std::string& name) {
  if (size < 0 || std::uint64_t(size) > kLargestRecording)
    throw error("{}: a key state in it is damaged; take an earlier copy of it", name);
  const std::string state = runInChild(name, limitsFor(std::size_t(size)),
                                       [&] { return unpacked(packed, std::size_t(size), name); });
  if (state.size() != std::size_t(size))
    throw error("{}: a key state in it is damaged; take an earlier copy of it", name);
  const auto bytes = std::as_bytes(std::span(state));
  return {bytes.begin(), bytes.end()};
}

}  // namespace resect
