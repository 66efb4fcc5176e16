#include "record/file/recording_file.h"

#include <fmt/format.h>
#include <zstd.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <type_traits>

#include "base/error.h"
#include "base/state/field_hashes.h"
#include "io/output/temporary_file.h"
#include "record/file/foreign_recording.h"
#include "record/file/row_columns.h"

namespace resect {
namespace {

constexpr std::int64_t kApplication = 0x52534354;  // "RSCT", shown by `file`

// Of a file that nobody has seen yet.
constexpr const char* kNoJournal = "PRAGMA journal_mode = MEMORY; PRAGMA synchronous = OFF;";

constexpr const char* kSchema = R"(
CREATE TABLE meta (key TEXT PRIMARY KEY, value TEXT NOT NULL);
CREATE TABLE scenario (name TEXT, title TEXT, description TEXT, setup BLOB NOT NULL);
CREATE TABLE organ (number INTEGER PRIMARY KEY, name TEXT, cells BLOB NOT NULL);
CREATE TABLE branch (number INTEGER PRIMARY KEY, parent INTEGER, from_frame INTEGER NOT NULL, name TEXT NOT NULL);
CREATE TABLE frames (branch INTEGER, frame INTEGER, time REAL NOT NULL, whole INTEGER NOT NULL, input BLOB NOT NULL,
                     hashes BLOB NOT NULL, PRIMARY KEY (branch, frame)) WITHOUT ROWID;
CREATE TABLE key_states (branch INTEGER, frame INTEGER, state_hash TEXT NOT NULL, size INTEGER NOT NULL,
                         state BLOB NOT NULL, PRIMARY KEY (branch, frame));
CREATE TABLE events (branch INTEGER, frame INTEGER, time REAL, tool INTEGER, organ INTEGER, kind TEXT, amount REAL,
                     text TEXT);
CREATE TABLE samples (branch INTEGER, frame INTEGER, tool INTEGER, x REAL, y REAL, z REAL, force_x REAL, force_y REAL,
                      force_z REAL);
CREATE TABLE ledger (branch INTEGER, frame INTEGER, time REAL, organ INTEGER, label INTEGER, part TEXT, number INTEGER,
                     particles INTEGER, ml REAL, g REAL);
CREATE TABLE wounds (branch INTEGER, frame INTEGER, organ INTEGER, label INTEGER, kind TEXT, amount REAL);
)";

Bytes packed(const Bytes& bytes) {
  Bytes out(::ZSTD_compressBound(bytes.size()));
  ZSTD_CCtx* context = ::ZSTD_createCCtx();
  ::ZSTD_CCtx_setParameter(context, ZSTD_c_compressionLevel, 3);
  ::ZSTD_CCtx_setParameter(context, ZSTD_c_checksumFlag, 1);
  const std::size_t size =
      ::ZSTD_compress2(context, out.data(), out.size(), bytes.data(), bytes.size());
  ::ZSTD_freeCCtx(context);
  if (::ZSTD_isError(size)) throw std::bad_alloc();
  out.resize(size);
  return out;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0, end; (end = text.find('\n', at)) != std::string::npos; at = end + 1)
    lines.push_back(text.substr(at, end - at));
  return lines;
}

double numberOf(const std::string& text) {
  double number = 0;  // whatever the decimal point of the locale is
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

std::span<const std::byte> bytesOf(std::string_view text) { return std::as_bytes(std::span(text)); }

}  // namespace

void makeRecordingTables(Database& db) {
  db.run(fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {};", kApplication,
                     kRecordingSchema));
  db.run(kSchema);
}

std::vector<std::filesystem::path> filesOfRecording(const std::filesystem::path& path) {
  return {path, path.string() + "-wal"};
}

RecordingFile RecordingFile::create(const std::filesystem::path& path, const RecordingInfo& info,
                                    const RecordedSetup& setup, const Branch& first,
                                    const KeyState& start) {
  RecordingFile file = appear(
      path, [&](const auto& begun) { begin(begun, path.string(), info, setup, first, start); });
  file.info_ = info;
  return file;
}

// A file that `fill` has filled, opened under its lasting name, to add to it.
RecordingFile RecordingFile::appear(const std::filesystem::path& path,
                                    const std::function<void(const std::filesystem::path&)>& fill) {
  Database::requireNothingAt(path);
  std::error_code ec;  // that a folder is missing is said when the file is created
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), ec);
  TemporaryFile begun(path);
  fill(begun.path());
  begun.publish();
  RecordingFile file{Database(path, path.string())};
  file.database_.run("PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL;");
  return file;
}

void RecordingFile::begin(const std::filesystem::path& path, const std::string& name,
                          const RecordingInfo& info, const RecordedSetup& setup,
                          const Branch& first, const KeyState& start) {
  RecordingFile file{Database(path, name)};
  Database& db = file.database_;
  db.run(kNoJournal);
  file.begin();
  makeRecordingTables(db);
  Statement meta(db, "INSERT INTO meta VALUES (?, ?)");
  const auto keep = [&](std::string_view key, std::string_view value) {
    meta.bind(0, key).bind(1, value).run();
  };
  keep("program", info.program);
  keep("instruction_set", info.instructionSet);
  keep("frame_rate", fmt::format("{}", info.frameRate));
  keep("fields", joined(info.fields));
  if (setup.scenario.task) keep("task", setup.scenario.task->text);
  if (setup.scenario.setting != "table") keep("setting", setup.scenario.setting);
  const SetupBytes bytes = toBytes(setup);
  Statement(db, "INSERT INTO scenario VALUES (?, ?, ?, ?)")
      .bind(0, std::string_view(setup.scenario.name))
      .bind(1, std::string_view(setup.scenario.title))
      .bind(2, std::string_view(setup.scenario.description))
      .bind(3, std::span<const std::byte>(bytes.scenario))
      .run();
  Statement organ(db, "INSERT INTO organ VALUES (?, ?, ?)");
  for (std::size_t i = 0; i < bytes.cells.size(); ++i)
    organ.bind(0, std::int64_t(i))
        .bind(1, std::string_view(setup.scenario.organs[i].source.name))
        .bind(2, bytesOf(bytes.cells[i]))
        .run();
  file.add(first);
  file.add(start);
  file.keepDigest(false);
  file.commit();
}

RecordingFile RecordingFile::goOn(const std::filesystem::path& path, RecordingFile& done) {
  RecordingFile file =
      appear(path, [&](const auto& begun) { done.copyTo(begun, path.string(), std::nullopt); });
  file.info_ = done.info_;
  file.mark(std::nullopt, false);
  return file;
}

void RecordingFile::copyTo(const std::filesystem::path& path, const std::string& name,
                           std::optional<Moment> moment) {
  if (moment)
    if (const std::int64_t last = lastFrame(moment->branch); last >= 0)
      moment->frame = std::min(moment->frame, last);
  try {
    database_.copyTo(path);
    RecordingFile copy{Database(path, name)};
    copy.database_.run(kNoJournal);
    copy.mark(moment, true);
  } catch (const Error& e) {
    throw error("{}: cannot be written ({}); free some space or choose another place", name,
                e.what());
  }
}

void RecordingFile::mark(std::optional<Moment> moment, bool complete) {
  begin();
  database_.run("DELETE FROM meta WHERE key IN ('branch', 'frame')");
  if (moment)
    database_.run(fmt::format("INSERT INTO meta VALUES ('branch', '{}'), ('frame', '{}')",
                              moment->branch, moment->frame));
  keepDigest(complete);
  commit();
}

RecordingFile RecordingFile::open(const std::filesystem::path& path, const Progress& progress) {
  RecordingFile file(Database::inMemory(path.string()));
  Database& db = file.database_;
  makeRecordingTables(db);
  file.damagedPage_ = addForeignRows(path, db, progress);
  Statement meta(db, "SELECT key, value FROM meta");
  std::string digest;
  while (meta.step()) {
    const std::string key = meta.text(0), value = meta.text(1);
    if (key == "program") file.info_.program = value;
    if (key == "instruction_set") file.info_.instructionSet = value;
    if (key == "frame_rate") file.info_.frameRate = numberOf(value);
    if (key == "fields") file.info_.fields = linesOf(value);
    if (key == "digest") digest = value;
  }
  if (digest != file.digest())
    throw error(
        "{}: its description, organs or branches were changed or are damaged; take an earlier copy "
        "of it",
        db.name());
  if (!(file.info_.frameRate >= 1 && file.info_.frameRate <= 1000))
    throw error("{}: its frame rate is not 1 to 1000; it is damaged", db.name());
  return file;
}

// Of what playing does not prove. Branches are written until the end, so they are in the digest of
// a complete recording only.
std::string RecordingFile::digest() {
  std::string rows;
  const auto add = [&](std::string_view sql) {
    Statement all(database_, sql);
    while (all.step()) appendRow(rows, all);
  };
  add("SELECT * FROM meta WHERE key <> 'digest' ORDER BY key");
  add("SELECT * FROM scenario");
  add("SELECT * FROM organ ORDER BY number");
  if (complete()) {
    add("SELECT * FROM branch ORDER BY number");
    add("SELECT branch, frame, whole FROM frames ORDER BY branch, frame");
  }
  return fmt::format("{:016x}", fastHash(rows.data(), rows.size()));
}

void RecordingFile::keepDigest(bool complete) {
  Statement meta(database_, "INSERT OR REPLACE INTO meta VALUES (?, ?)");
  meta.bind(0, std::string_view("complete")).bind(1, std::string_view(complete ? "yes" : "no"));
  meta.run();
  meta.bind(0, std::string_view("digest")).bind(1, std::string_view(digest())).run();
}

RecordedSetup RecordingFile::setup() {
  SetupBytes bytes;
  Statement scenario(database_, "SELECT setup FROM scenario");
  if (!scenario.step()) throw error("{}: holds no scenario; it is damaged", database_.name());
  const auto blob = scenario.blob(0);
  bytes.scenario.assign(blob.begin(), blob.end());
  Statement organ(database_, "SELECT cells FROM organ ORDER BY number");
  while (organ.step()) {
    const auto cells = organ.blob(0);
    bytes.cells.emplace_back(reinterpret_cast<const char*>(cells.data()), cells.size());
  }
  RecordedSetup setup = setupFromBytes(bytes);
  if (const std::string setting = meta("setting"); !setting.empty())
    setup.scenario.setting = setting;
  return setup;
}

std::string RecordingFile::meta(std::string_view key) {
  Statement value(database_, "SELECT value FROM meta WHERE key = ?");
  value.bind(0, key);
  return value.step() ? value.text(0) : "";
}

std::string RecordingFile::task() { return meta("task"); }

Statement& RecordingFile::prepared(const std::string& sql) {
  std::unique_ptr<Statement>& statement = statements_[sql];
  if (!statement) statement = std::make_unique<Statement>(database_, sql);
  return *statement;
}

void RecordingFile::setProgram(const std::string& program) {
  Statement(database_, "UPDATE meta SET value = ? WHERE key = 'program'")
      .bind(0, std::string_view(program))
      .run();
  keepDigest(complete());
}

void RecordingFile::begin() { database_.run("BEGIN"); }
void RecordingFile::commit() { database_.run("COMMIT"); }
void RecordingFile::rollback() {
  try {
    database_.run("ROLLBACK");
  } catch (const Error&) {  // SQLite has done so by itself
  }
}

template <class Row>
void RecordingFile::insert(const Row& row) {
  columns(
      [&](const char* table, const auto&... values) {
        // A branch may get another name, and the state at which it begins may be given twice.
        constexpr bool again = std::is_same_v<Row, StoredKeyState> || std::is_same_v<Row, Branch>;
        std::string sql =
            fmt::format("INSERT {}INTO {} VALUES (?", again ? "OR REPLACE " : "", table);
        for (std::size_t i = 1; i < sizeof...(values); ++i) sql += ", ?";
        Statement& statement = prepared(sql + ")");
        int column = 0;
        (bindColumn(statement, column++, values), ...);
        statement.run();
      },
      const_cast<Row&>(row));  // it is only read
}

void RecordingFile::add(const Branch& branch) { insert(branch); }
void RecordingFile::add(const RecordedFrame& frame) { insert(frame); }
void RecordingFile::add(const OperationEvent& event) { insert(event); }
void RecordingFile::add(const RecordedSample& sample) { insert(sample); }
void RecordingFile::add(const KeyState& state) {
  insert(StoredKeyState{state.branch, state.frame, fmt::format("{:016x}", state.stateHash),
                        std::int64_t(state.state.size()), packed(state.state)});
}

void RecordingFile::add(const RecordedLedger& l) {
  Statement& amount = prepared("INSERT INTO ledger VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  for (const RecordedLedger::Amount& a : l.amounts) {
    amount.bind(0, l.branch).bind(1, l.frame).bind(2, l.time).bind(3, a.organ).bind(4, a.label);
    amount.bind(5, std::string_view(a.part)).bind(6, a.number).bind(7, a.particles);
    amount.bind(8, a.ml).bind(9, a.g).run();
  }
  Statement& wound = prepared("INSERT INTO wounds VALUES (?, ?, ?, ?, ?, ?)");
  for (const RecordedLedger::Wound& w : l.wounds) {
    wound.bind(0, l.branch).bind(1, l.frame).bind(2, w.organ).bind(3, w.label);
    wound.bind(4, std::string_view(w.kind)).bind(5, w.amount).run();
  }
}

void RecordingFile::finish() {
  statements_.clear();
  begin();
  keepDigest(true);
  commit();
  database_.run("PRAGMA wal_checkpoint(TRUNCATE); PRAGMA journal_mode = DELETE;");
}

bool RecordingFile::complete() {
  return database_.number("SELECT count(*) FROM meta WHERE key = 'complete' AND value = 'yes'") > 0;
}

std::string RecordingFile::damagedPage() { return damagedPage_; }

}  // namespace resect
