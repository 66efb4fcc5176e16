#include "record/recording_file.h"

#include <fmt/format.h>
#include <zstd.h>

#include <cstdlib>
#include <cstring>

#include "base/error.h"

namespace resect {
namespace {

constexpr std::int64_t kApplication = 0x52534354;  // "RSCT", shown by `file`
constexpr std::size_t kLargestState = std::size_t(4) << 30;

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

Bytes unpacked(std::span<const std::byte> bytes, std::int64_t size, const std::string& name) {
  const auto damaged = [&] {
    return error("{}: a key state in it is damaged; take an earlier copy of it", name);
  };
  if (size < 0 || std::uint64_t(size) > kLargestState ||
      ::ZSTD_getFrameContentSize(bytes.data(), bytes.size()) != std::uint64_t(size))
    throw damaged();
  Bytes out(static_cast<std::size_t>(size));
  const std::size_t got = ::ZSTD_decompress(out.data(), out.size(), bytes.data(), bytes.size());
  if (::ZSTD_isError(got) || got != out.size()) throw damaged();
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

// All that a database defines: tables, and whatever else somebody put into it.
std::string tablesOf(Database& db) {
  Statement rows(db, "SELECT type || name || coalesce(sql, '') FROM sqlite_master ORDER BY name");
  std::string all;
  while (rows.step()) all += rows.text(0) + "\n";
  return all;
}

std::string ownTables() {
  Database memory;
  memory.run(kSchema);
  return tablesOf(memory);
}

std::span<const std::byte> bytesOf(std::string_view text) { return std::as_bytes(std::span(text)); }

}  // namespace

RecordingFile RecordingFile::create(const std::filesystem::path& path, const RecordingInfo& info,
                                    const RecordedSetup& setup) {
  RecordingFile file(path, Database::Mode::Create);
  Database& db = file.database_;
  file.info_ = info;
  db.run("PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL;");
  db.run(fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {};", kApplication,
                     kRecordingSchema));
  file.begin();
  db.run(kSchema);
  Statement meta(db, "INSERT INTO meta VALUES (?, ?)");
  const auto keep = [&](std::string_view key, std::string_view value) {
    meta.bind(0, key).bind(1, value).run();
  };
  keep("program", info.program);
  keep("instruction_set", info.instructionSet);
  keep("frame_rate", fmt::format("{}", info.frameRate));
  keep("fields", joined(info.fields));
  keep("complete", "no");
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
  file.commit();
  return file;
}

RecordingFile RecordingFile::goOn(const std::filesystem::path& path, RecordingFile& done) {
  done.copyTo(path);
  RecordingFile file(path, Database::Mode::GoOn);
  file.info_ = done.info_;
  file.database_.run("PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL;");
  file.database_.run("UPDATE meta SET value = 'no' WHERE key = 'complete'");
  return file;
}

void RecordingFile::copyTo(const std::filesystem::path& path) {
  const auto setComplete = [&](const std::string& value) {
    Statement(database_, "UPDATE meta SET value = ? WHERE key = 'complete'")
        .bind(0, std::string_view(value))
        .run();
  };
  // VACUUM takes everything as it is, so the copy's mark is set for the moment.
  const std::string before = complete() ? "yes" : "no";
  setComplete("yes");
  try {
    database_.copyTo(path);
  } catch (...) {
    setComplete(before);
    throw;
  }
  setComplete(before);
}

RecordingFile RecordingFile::open(const std::filesystem::path& path) {
  RecordingFile file(path, Database::Mode::Copy);
  Database& db = file.database_;
  if (db.number("PRAGMA application_id") != kApplication)
    throw error("{}: is no recording of Resect; choose a .resect file", db.name());
  if (const std::int64_t version = db.number("PRAGMA user_version"); version != kRecordingSchema)
    throw error(
        "{}: has version {} of the schema, and this program reads version {}; use a newer "
        "Resect",
        db.name(), version, kRecordingSchema);
  if (tablesOf(db) != ownTables())
    throw error("{}: its tables are not those of a recording; choose another file", db.name());
  Statement meta(db, "SELECT key, value FROM meta");
  while (meta.step()) {
    const std::string key = meta.text(0), value = meta.text(1);
    if (key == "program") file.info_.program = value;
    if (key == "instruction_set") file.info_.instructionSet = value;
    if (key == "frame_rate") file.info_.frameRate = std::atof(value.c_str());
    if (key == "fields") file.info_.fields = linesOf(value);
  }
  if (!(file.info_.frameRate >= 1 && file.info_.frameRate <= 1000))
    throw error("{}: its frame rate is not 1 to 1000; it is damaged", db.name());
  return file;
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
  return setupFromBytes(bytes);
}

Statement& RecordingFile::prepared(std::size_t slot, std::string_view sql) {
  if (statements_.size() <= slot) statements_.resize(slot + 1);
  if (!statements_[slot]) statements_[slot] = std::make_unique<Statement>(database_, sql);
  return *statements_[slot];
}

void RecordingFile::begin() { database_.run("BEGIN"); }
void RecordingFile::commit() { database_.run("COMMIT"); }

void RecordingFile::add(const Branch& branch) {
  prepared(0, "INSERT INTO branch VALUES (?, ?, ?, ?)")
      .bind(0, branch.number)
      .bind(1, branch.parent)
      .bind(2, branch.from)
      .bind(3, std::string_view(branch.name))
      .run();
}

void RecordingFile::add(const RecordedFrame& frame) {
  prepared(1, "INSERT INTO frames VALUES (?, ?, ?, ?, ?, ?)")
      .bind(0, frame.branch)
      .bind(1, frame.frame)
      .bind(2, frame.time)
      .bind(3, std::int64_t(frame.whole))
      .bind(4, std::span<const std::byte>(frame.input))
      .bind(5, std::as_bytes(std::span(frame.hashes)))
      .run();
}

void RecordingFile::add(const KeyState& state) {
  prepared(2, "INSERT OR REPLACE INTO key_states VALUES (?, ?, ?, ?, ?)")
      .bind(0, state.branch)
      .bind(1, state.frame)
      .bind(2, std::string_view(fmt::format("{:016x}", state.stateHash)))
      .bind(3, std::int64_t(state.state.size()))
      .bind(4, std::span<const std::byte>(packed(state.state)))
      .run();
}

void RecordingFile::add(const OperationEvent& event) {
  prepared(3, "INSERT INTO events VALUES (?, ?, ?, ?, ?, ?, ?, ?)")
      .bind(0, event.branch)
      .bind(1, event.frame)
      .bind(2, event.time)
      .bind(3, event.tool)
      .bind(4, event.organ)
      .bind(5, std::string_view(event.kind))
      .bind(6, event.amount)
      .bind(7, std::string_view(event.text))
      .run();
}

void RecordingFile::add(const RecordedSample& sample) {
  Statement& insert = prepared(4, "INSERT INTO samples VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)");
  insert.bind(0, sample.branch).bind(1, sample.frame).bind(2, sample.tool);
  for (int a = 0; a < 3; ++a) insert.bind(3 + a, sample.tip[a]).bind(6 + a, sample.force[a]);
  insert.run();
}

void RecordingFile::finish() {
  statements_.clear();
  database_.run("UPDATE meta SET value = 'yes' WHERE key = 'complete'");
  database_.run("PRAGMA wal_checkpoint(TRUNCATE); PRAGMA journal_mode = DELETE;");
}

std::vector<Branch> RecordingFile::branches() {
  std::vector<Branch> branches;
  Statement rows(database_, "SELECT number, parent, from_frame, name FROM branch ORDER BY number");
  while (rows.step())
    branches.push_back({rows.integer(0), rows.integer(1), rows.integer(2), rows.text(3)});
  return branches;
}

std::int64_t RecordingFile::lastFrame(std::int64_t branch) {
  Statement row(database_, "SELECT max(frame), count(*) FROM frames WHERE branch = ?");
  row.bind(0, branch);
  return row.step() && row.integer(1) > 0 ? row.integer(0) : -1;
}

std::int64_t RecordingFile::lastBranch() {
  return database_.number(
      "SELECT coalesce((SELECT branch FROM events ORDER BY rowid DESC LIMIT 1), max(number)) "
      "FROM branch");
}

std::optional<RecordedFrame> RecordingFile::frame(std::int64_t branch, std::int64_t number) {
  Statement& row =
      prepared(5, "SELECT time, whole, input, hashes FROM frames WHERE branch = ? AND frame = ?");
  row.bind(0, branch).bind(1, number);
  if (!row.step()) return std::nullopt;
  RecordedFrame frame{branch, number, row.real(0), row.integer(1) != 0, {}, {}};
  const auto input = row.blob(2);
  frame.input.assign(input.begin(), input.end());
  const auto hashes = row.blob(3);
  frame.hashes.resize(hashes.size() / sizeof(std::uint64_t));
  if (!hashes.empty())
    std::memcpy(frame.hashes.data(), hashes.data(), frame.hashes.size() * sizeof(std::uint64_t));
  while (row.step()) {  // to its end, so that it can be bound again
  }
  return frame;
}

std::optional<KeyState> RecordingFile::keyState(std::int64_t branch, std::int64_t frame) {
  Statement row(
      database_,
      "SELECT frame, state_hash, size, state FROM key_states WHERE branch = ? AND frame <= ? "
      "ORDER BY frame DESC LIMIT 1");
  row.bind(0, branch).bind(1, frame);
  if (!row.step()) return std::nullopt;
  return KeyState{branch, row.integer(0), unpacked(row.blob(3), row.integer(2), database_.name()),
                  std::strtoull(row.text(1).c_str(), nullptr, 16)};
}

std::vector<std::int64_t> RecordingFile::keyFrames(std::int64_t branch) {
  std::vector<std::int64_t> frames;
  Statement rows(database_, "SELECT frame FROM key_states WHERE branch = ? ORDER BY frame");
  rows.bind(0, branch);
  while (rows.step()) frames.push_back(rows.integer(0));
  return frames;
}

std::vector<OperationEvent> RecordingFile::events(std::int64_t branch) {
  std::vector<OperationEvent> events;
  Statement rows(database_,
                 "SELECT frame, time, tool, organ, kind, amount, text FROM events WHERE branch = ? "
                 "ORDER BY rowid");
  rows.bind(0, branch);
  while (rows.step())
    events.push_back({branch, rows.integer(0), rows.real(1), rows.integer(2), rows.integer(3),
                      rows.text(4), rows.real(5), rows.text(6)});
  return events;
}

std::vector<RecordedSample> RecordingFile::samples(std::int64_t branch, std::int64_t frame) {
  std::vector<RecordedSample> samples;
  Statement& rows = prepared(6,
                             "SELECT tool, x, y, z, force_x, force_y, force_z FROM samples "
                             "WHERE branch = ? AND frame = ? ORDER BY tool");
  rows.bind(0, branch).bind(1, frame);
  while (rows.step()) {
    RecordedSample sample{branch, frame, rows.integer(0), {}, {}};
    for (int a = 0; a < 3; ++a)
      sample.tip[a] = rows.real(1 + a), sample.force[a] = rows.real(4 + a);
    samples.push_back(sample);
  }
  return samples;
}

bool RecordingFile::complete() {
  return database_.number("SELECT count(*) FROM meta WHERE key = 'complete' AND value = 'yes'") > 0;
}

std::string RecordingFile::damagedPage() {
  Statement check(database_, "PRAGMA integrity_check(1)");
  const std::string found = check.step() ? check.text(0) : "";
  return found == "ok" ? "" : found;
}

}  // namespace resect
