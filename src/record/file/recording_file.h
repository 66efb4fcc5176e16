// The file of a recording: a SQLite database with the tables that docs/recording.md describes.
//
// This is the store only: it keeps rows and gives them back. record/recorder.h fills it while an
// operation runs; record/replay.h plays it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "base/progress.h"
#include "operation/live/branch.h"
#include "operation/live/operation_events.h"
#include "record/file/database.h"
#include "record/recorded_setup.h"

namespace resect {

inline constexpr int kRecordingSchema = 4;
inline constexpr std::size_t kLargestRecording = std::size_t(1) << 30;  // bytes, with its log

// The files that hold a recording: while it is written, and after a program was killed, its log
// too.
std::vector<std::filesystem::path> filesOfRecording(const std::filesystem::path& path);

// A frame as stored. Frames of a branch are numbered by Simulation::frame() after the step.
struct RecordedFrame {
  std::int64_t branch = 0, frame = 0;
  double time = 0;     // s, at the frame's end
  bool whole = false;  // the input is written in full, not as the difference to the frame before
  Bytes input;         // record/file/frame_bytes.h
  // The digest of `input`, then one per field of the state (RecordingInfo::fields).
  std::vector<std::uint64_t> hashes;
};

// A state from which playing can begin.
struct KeyState {
  std::int64_t branch = 0, frame = 0;
  Bytes state;                  // Simulation::save()
  std::uint64_t stateHash = 0;  // of the surface too
};

// Where a tool in hand was and what it felt.
struct RecordedSample {
  std::int64_t branch = 0, frame = 0, tool = 0;
  double tip[3] = {}, force[3] = {};  // world, m and N
};

// The ledger after a frame (operation/ledger/ledger.h), as rows of the tables `ledger` and
// `wounds`.
struct RecordedLedger {
  struct Amount {
    std::int64_t organ = 0, label = 0;
    std::string part;         // before, body, piece, debris, removed
    std::int64_t number = 0;  // of a piece, from 1 on, the largest first; else 0
    std::int64_t particles = 0;
    double ml = 0, g = 0;
    bool operator==(const Amount&) const = default;
  };
  struct Wound {
    std::int64_t organ = 0, label = -1;  // -1: none
    std::string kind;                    // cut, bared (cm^2); margin (mm)
    double amount = 0;
    bool operator==(const Wound&) const = default;
  };
  std::int64_t branch = 0, frame = 0;
  double time = 0;  // s
  std::vector<Amount> amounts;
  std::vector<Wound> wounds;
  bool operator==(const RecordedLedger&) const = default;
};

struct RecordingInfo {
  std::string program;         // "resect 0.1.0"
  std::string instructionSet;  // of the processor that recorded
  double frameRate = 60;
  std::vector<std::string> fields;  // names for RecordedFrame::hashes after the first
};

// The marks and the tables of a recording, in an empty database.
void makeRecordingTables(Database& database);

class RecordingFile {
 public:
  // A new file; nothing may be there under that name. It appears with all of these in it: what has
  // the name is a recording. first, start: branch 0 and the state at which it begins.
  static RecordingFile create(const std::filesystem::path& path, const RecordingInfo& info,
                              const RecordedSetup& setup, const Branch& first,
                              const KeyState& start);
  // A new file at `path` that holds all that `done` holds, to add to. Throws Error if something is
  // there, or if this program computes other fields than the one that made `done`.
  static RecordingFile goOn(const std::filesystem::path& path, RecordingFile& done);
  // Reads a finished or an interrupted recording into memory, through the sandbox
  // (record/file/foreign_recording.h). Throws Error if it is none, is of a newer
  // schema, has other tables than a recording, or if what playing does not prove was changed: its
  // description, organs, branches.
  static RecordingFile open(const std::filesystem::path& path, const Progress& progress = {});

  const RecordingInfo& info() const { return info_; }
  const std::string& name() const { return database_.name(); }
  RecordedSetup setup();

  // As if another program had recorded (for tests).
  void setProgram(const std::string& program);

  void begin();  // a transaction: what follows is kept together or not at all
  void commit();
  void rollback();  // what was added since begin() is not kept
  void add(const Branch& branch);
  void add(const RecordedFrame& frame);
  void add(const KeyState& state);  // compressed
  void add(const OperationEvent& event);
  void add(const RecordedSample& sample);
  void add(const RecordedLedger& ledger);
  // Writes all that is there as a finished recording of its own into an empty file. Not between
  // begin() and commit(). name: of the file, in messages. moment: at which the operation is, for
  // moment() of the copy.
  void copyTo(const std::filesystem::path& path, const std::string& name,
              std::optional<Moment> moment);
  void finish();  // marks it complete and folds the write-ahead log into the file

  std::vector<Branch> branches();
  std::int64_t lastFrame(std::int64_t branch);  // -1 without frames
  // Where the operation was when it was saved; else the end of the branch in which the last event
  // happened.
  Moment moment();
  std::optional<RecordedFrame> frame(std::int64_t branch, std::int64_t number);
  // The latest key state of the branch at `frame` or before.
  std::optional<KeyState> keyState(std::int64_t branch, std::int64_t frame);
  std::vector<std::int64_t> keyFrames(std::int64_t branch);
  std::int64_t keyStateBytes();  // of all, unpacked
  std::vector<OperationEvent> events(std::int64_t branch);
  std::vector<RecordedSample> samples(std::int64_t branch);  // frame by frame
  std::vector<RecordedLedger> ledgers(std::int64_t branch);
  bool complete();            // false: the program ended before the recording did
  std::string damagedPage();  // what SQLite's own check finds, in one line; empty: nothing

 private:
  explicit RecordingFile(Database database)
      : opened_(std::make_unique<Database>(std::move(database))), database_(*opened_) {}
  static RecordingFile appear(const std::filesystem::path& path,
                              const std::function<void(const std::filesystem::path&)>& fill);
  static void begin(const std::filesystem::path& path, const std::string& name,
                    const RecordingInfo& info, const RecordedSetup& setup, const Branch& first,
                    const KeyState& start);
  void mark(std::optional<Moment> moment, bool complete);
  Statement& prepared(const std::string& sql);
  template <class Row>
  void insert(const Row& row);
  void keepDigest(bool complete);
  std::string digest();

  std::unique_ptr<Database> opened_;  // on the heap, since statements refer to it
  Database& database_;
  RecordingInfo info_;
  std::string damagedPage_;
  std::unordered_map<std::string, std::unique_ptr<Statement>> statements_;  // to be used again
};

}  // namespace resect
