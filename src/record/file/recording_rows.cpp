// What a recording holds, row by row.
#include <cstdlib>

#include "base/error.h"
#include "record/file/foreign_recording.h"
#include "record/file/recording_file.h"
#include "record/file/row_columns.h"

namespace resect {

std::vector<Branch> RecordingFile::branches() {
  return rowsOf<Branch>(prepared("SELECT * FROM branch ORDER BY number"));
}

std::int64_t RecordingFile::lastFrame(std::int64_t branch) {
  Statement row(database_, "SELECT max(frame), count(*) FROM frames WHERE branch = ?");
  row.bind(0, branch);
  return row.step() && row.integer(1) > 0 ? row.integer(0) : -1;
}

Moment RecordingFile::moment() {
  Moment moment;
  moment.branch = database_.number(
      "SELECT coalesce((SELECT branch FROM events ORDER BY rowid DESC LIMIT 1), max(number)) "
      "FROM branch");
  moment.frame = std::max<std::int64_t>(0, lastFrame(moment.branch));
  Statement kept(database_, "SELECT value FROM meta WHERE key = ?");
  const auto number = [&](std::string_view key, std::int64_t& to) {
    kept.bind(0, key);
    if (kept.step()) to = std::atoll(kept.text(0).c_str());
    while (kept.step()) {
    }
  };
  number("branch", moment.branch), number("frame", moment.frame);
  return moment;
}

std::optional<RecordedFrame> RecordingFile::frame(std::int64_t branch, std::int64_t number) {
  auto found = rowsOf<RecordedFrame>(prepared("SELECT * FROM frames WHERE branch = ? AND frame = ?")
                                         .bind(0, branch)
                                         .bind(1, number));
  if (found.empty()) return std::nullopt;
  return std::move(found[0]);
}

std::optional<KeyState> RecordingFile::keyState(std::int64_t branch, std::int64_t frame) {
  const auto found = rowsOf<StoredKeyState>(
      prepared(
          "SELECT * FROM key_states WHERE branch = ? AND frame <= ? ORDER BY frame DESC LIMIT 1")
          .bind(0, branch)
          .bind(1, frame));
  if (found.empty()) return std::nullopt;
  const StoredKeyState& key = found[0];
  return KeyState{branch, key.frame, unpackForeign(key.state, key.size, database_.name()),
                  std::strtoull(key.hash.c_str(), nullptr, 16)};
}

std::vector<std::int64_t> RecordingFile::keyFrames(std::int64_t branch) {
  std::vector<std::int64_t> frames;
  Statement rows(database_, "SELECT frame FROM key_states WHERE branch = ? ORDER BY frame");
  rows.bind(0, branch);
  while (rows.step()) frames.push_back(rows.integer(0));
  return frames;
}

std::int64_t RecordingFile::keyStateBytes() {
  return database_.number("SELECT sum(size) FROM key_states");
}

std::vector<OperationEvent> RecordingFile::events(std::int64_t branch) {
  return rowsOf<OperationEvent>(
      prepared("SELECT * FROM events WHERE branch = ? ORDER BY rowid").bind(0, branch));
}

std::vector<RecordedSample> RecordingFile::samples(std::int64_t branch) {
  return rowsOf<RecordedSample>(
      prepared("SELECT * FROM samples WHERE branch = ? ORDER BY rowid").bind(0, branch));
}

std::vector<RecordedLedger> RecordingFile::ledgers(std::int64_t branch) {
  std::vector<RecordedLedger> ledgers;
  Statement amounts(database_,
                    "SELECT frame, time, organ, label, part, number, particles, ml, g FROM ledger "
                    "WHERE branch = ? ORDER BY frame, rowid");
  amounts.bind(0, branch);
  while (amounts.step()) {
    const std::int64_t frame = amounts.integer(0);
    if (ledgers.empty() || ledgers.back().frame != frame)
      ledgers.push_back({branch, frame, amounts.real(1), {}, {}});
    ledgers.back().amounts.push_back({amounts.integer(2), amounts.integer(3), amounts.text(4),
                                      amounts.integer(5), amounts.integer(6), amounts.real(7),
                                      amounts.real(8)});
  }
  Statement wounds(database_,
                   "SELECT frame, organ, label, kind, amount FROM wounds WHERE branch = ? "
                   "ORDER BY frame, rowid");
  wounds.bind(0, branch);
  for (std::size_t i = 0; wounds.step();) {
    while (i < ledgers.size() && ledgers[i].frame < wounds.integer(0)) ++i;
    if (i == ledgers.size() || ledgers[i].frame != wounds.integer(0))
      throw error("{}: a wound in it belongs to no ledger; take an earlier copy of it",
                  database_.name());
    ledgers[i].wounds.push_back(
        {wounds.integer(1), wounds.integer(2), wounds.text(3), wounds.real(4)});
  }
  return ledgers;
}

}  // namespace resect
