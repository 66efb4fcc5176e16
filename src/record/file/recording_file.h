// The file of a recording: a SQLite database with the tables that docs/recording.md describes.
//
// RecordingFile only stores and reads rows. record/recorder.h fills the file while an operation
// runs. record/replay.h plays the file: it computes the recorded frames again from their inputs. If
// the user goes back and operates from an earlier moment, a new branch of the operation begins
// (operation/live/branch.h).
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

inline constexpr int kRecordingSchema = 8;
// Largest size of a recording, bytes, including its write-ahead log.
inline constexpr std::size_t kLargestRecording = std::size_t(1) << 30;

// The files that may hold a recording: the database, and SQLite's write-ahead log, whose name ends
// in -wal. The log exists while the recording is being written. It also remains if the program was
// killed.
std::vector<std::filesystem::path> filesOfRecording(const std::filesystem::path& path);

// A frame as stored. `frame` is Simulation::frame() after the step that computes the frame.
struct RecordedFrame {
  std::int64_t branch = 0, frame = 0;
  double time = 0;     // simulated time at the frame's end, s
  bool whole = false;  // `input` is complete, not the difference from the previous frame
  Bytes input;         // record/file/frame_bytes.h
  // The digest of `input`, then one digest per field of the state (RecordingInfo::fields).
  std::vector<std::uint64_t> hashes;
};

// A state of the simulation, from which playing can begin.
struct KeyState {
  std::int64_t branch = 0, frame = 0;
  Bytes state;                  // Simulation::save()
  std::uint64_t stateHash = 0;  // of the state and the surface (Simulation::stateHash())
};

// For a tool in hand: the position of its tip at the end of a frame, and the mean force on the tool
// in this frame.
struct RecordedSample {
  std::int64_t branch = 0, frame = 0, tool = 0;
  double tip[3] = {}, force[3] = {};  // world, m and N
};

// The ledger after a frame, as rows of the tables `ledger` and `wounds`. A ledger is an account of
// all tissue (operation/ledger/ledger.h).
struct RecordedLedger {
  struct Amount {
    // label: number of the structure to which the tissue belongs (Discretization::label).
    std::int64_t organ = 0, label = 0;
    // "before": all tissue before the operation. "body", "piece", "debris" and "removed": what the
    // tissue now belongs to (TissueSplit).
    std::string part;
    // Number of the piece: 1 for the largest piece, 2 for the next, and so on. 0 for other parts.
    std::int64_t number = 0;
    std::int64_t particles = 0;
    double ml = 0, g = 0;
    bool operator==(const Amount&) const = default;
  };
  struct Wound {
    std::int64_t organ = 0, label = -1;  // -1: none
    // "cut" or "bared": `amount` is the area of cut faces, or of faces bared by removing tissue,
    // cm^2. "margin": `amount` is the least distance of the structure `label` from any cut or bared
    // face, mm.
    std::string kind;
    double amount = 0;
    bool operator==(const Wound&) const = default;
  };
  std::int64_t branch = 0, frame = 0;
  double time = 0;  // simulated time, s
  std::vector<Amount> amounts;
  std::vector<Wound> wounds;
  bool operator==(const RecordedLedger&) const = default;
};

struct RecordingInfo {
  std::string program;         // "resect 0.1.0"
  std::string instructionSet;  // of the processor on which it was recorded
  double frameRate = 60;
  // Names of the digests in RecordedFrame::hashes, from the second digest on.
  std::vector<std::string> fields;
};

// Turns an empty database into a recording without rows: sets the application id and the schema
// version, and creates the tables.
void makeRecordingTables(Database& database);

class RecordingFile {
 public:
  // Creates a file; throws Error if a file exists at `path`. first: branch 0. start: the state at
  // which branch 0 begins. The file is first written under a temporary name. It gets its own name
  // when it contains `info`, `setup`, `first` and `start`. So a file at `path` is always a valid
  // recording.
  static RecordingFile create(const std::filesystem::path& path, const RecordingInfo& info,
                              const RecordedSetup& setup, const Branch& first,
                              const KeyState& start);
  // Creates a file at `path` with a copy of everything in `done`, so that more can be added. Throws
  // Error if a file exists at `path`. `done` has digests of the fields of a state. Recorder's
  // constructor checks that the state of this program has no other fields; goOn() does not check
  // this.
  static RecordingFile goOn(const std::filesystem::path& path, RecordingFile& done);
  // Reads a finished or an interrupted recording into memory, through the sandbox
  // (record/file/foreign_recording.h). Throws Error if the file is not a recording, or if its
  // tables are not those of a recording. Throws Error if the version of its schema is older or
  // newer than kRecordingSchema. Also throws Error if the frame rate is not 1 to 1000, or if the
  // digest in the file does not match. The digest covers what a replay cannot verify: the table
  // meta, the scenario, the organs and, in a finished recording, the branches.
  static RecordingFile open(const std::filesystem::path& path, const Progress& progress = {});

  const RecordingInfo& info() const { return info_; }
  const std::string& name() const { return database_.name(); }
  RecordedSetup setup();
  // The text of the scenario's task (Task::text); empty if the scenario had no task.
  std::string task();

  // Replaces the stored name of the program that recorded (for tests).
  void setProgram(const std::string& program);

  void begin();  // begins a transaction
  void commit();
  void rollback();  // removes everything that was added since begin()
  void add(const Branch& branch);
  void add(const RecordedFrame& frame);
  void add(const KeyState& state);  // stores it compressed
  void add(const OperationEvent& event);
  void add(const RecordedSample& sample);
  void add(const RecordedLedger& ledger);
  // Copies everything into an empty file and marks the copy as a finished recording. Must not be
  // called between begin() and commit(). name: the file's name in messages. moment: what moment()
  // returns for the copy. If the frame in `moment` is after the end of its branch, moment() returns
  // the last frame of this branch.
  void copyTo(const std::filesystem::path& path, const std::string& name,
              std::optional<Moment> moment);
  // Marks the recording as complete and merges the write-ahead log into the file.
  void finish();

  std::vector<Branch> branches();
  std::int64_t lastFrame(std::int64_t branch);  // -1 if the branch has no frames
  // If copyTo() made this file and was given a moment, that moment. Otherwise the end of a branch:
  // the branch in which the last event happened or, without events, the last branch.
  Moment moment();
  std::optional<RecordedFrame> frame(std::int64_t branch, std::int64_t number);
  // The last key state of the branch at or before the frame `frame`.
  std::optional<KeyState> keyState(std::int64_t branch, std::int64_t frame);
  std::vector<std::int64_t> keyFrames(std::int64_t branch);
  std::int64_t keyStateBytes();  // of all key states, decompressed
  std::vector<OperationEvent> events(std::int64_t branch);
  std::vector<RecordedSample> samples(std::int64_t branch);  // in the order of frames
  std::vector<RecordedLedger> ledgers(std::int64_t branch);
  // Whether finish() or copyTo() has marked the recording as complete. False if, for example, the
  // program was killed during the recording.
  bool complete();
  // What SQLite's integrity check found at open(), in one line; empty if it found nothing.
  std::string damagedPage();

 private:
  std::string meta(std::string_view key);  // the value of `key` in the table meta; empty: none
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

  std::unique_ptr<Database> opened_;  // on the heap, since statements hold references to it
  Database& database_;
  RecordingInfo info_;
  std::string damagedPage_;
  std::unordered_map<std::string, std::unique_ptr<Statement>> statements_;  // by their SQL
};

}  // namespace resect
