// Records an operation while it happens.
//
// The thread that steps the simulation hands over each frame; a thread of the recorder's own writes
// it. When the program is killed at any moment, the file opens and holds all but the last quarter
// second. If the disk is full or the file cannot be written, the recording ends with a sentence and
// the operation goes on.
#pragma once

#include <atomic>
#include <condition_variable>
#include <deque>
#include <filesystem>
#include <mutex>
#include <string>
#include <thread>
#include <variant>
#include <vector>

#include "base/state/field_hashes.h"
#include "operation/ledger/ledger.h"
#include "record/file/recording_file.h"

namespace resect {

// This program, as RecordingInfo names it.
std::string programName();

// Digests of the state's fields after a step, in the order of fields().
class FrameHashes {
 public:
  // start: at the start of the operation, whose fields are kept.
  explicit FrameHashes(const Simulation& start);
  // The fields of a recording.
  explicit FrameHashes(std::vector<std::string> fields) : hashes_(std::move(fields)) {}
  const std::vector<std::uint64_t>& of(const Simulation& simulation);
  const std::vector<std::string>& fields() const { return hashes_.paths(); }
  // Whether the state has a field that is not among them.
  bool strange() const { return hashes_.strange(); }

 private:
  FieldHashes hashes_;
};

// Where the tools in hand are and what they feel, after the step of the report.
std::vector<RecordedSample> samplesOf(const StepReport& report, const Simulation& simulation);

class Recorder {
 public:
  // Creates the file; throws Error if that fails. simulation: at its start, where branch 0 begins.
  Recorder(const std::filesystem::path& path, const Scenario& scenario,
           const Simulation& simulation);
  // Creates a file that holds all that `done` holds, to which more will be added. scenario,
  // simulation: of the operation that goes on. Throws Error also if the two keep different fields.
  Recorder(const std::filesystem::path& path, RecordingFile& done, const Scenario& scenario,
           const Simulation& simulation);
  ~Recorder();  // as finish()
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  // The two below are called by the thread that steps.
  // A branch begins at the present state.
  void begin(const Branch& branch, const Simulation& simulation);
  void rename(const Branch& branch);
  // Operating pauses at the end of a branch: its ledger is kept.
  void stood(Moment moment, const Simulation& simulation);
  // After each step; the frame follows the last one of its branch. Cost: 0.5 ms at 13 000 elastic
  // particles, and the time of Simulation::save() and stateHash() once in kKeyStateSeconds.
  void record(Moment moment, const FrameInput& input, const StepReport& report,
              std::span<const OperationEvent> events, const Simulation& simulation);
  // The same for an operation with one branch alone.
  void record(const FrameInput& input, const StepReport& report, const Simulation& simulation);

  // Why nothing is recorded any more; empty while all is well.
  std::string failure() const;
  // Bytes of the file so far.
  std::uintmax_t size() const;
  // Writes all that is recorded so far as a file of its own, whole or not at all; replaces `path`.
  // Waits until it is done. Throws Error if that fails, and also if the recording has ended: the
  // file then holds all until then. moment: at which the operation is; kEndOfBranch: it goes on at
  // the end of that branch.
  void saveAs(const std::filesystem::path& path, Moment moment);
  // Waits until all is written and closes the file.
  void finish();

  const std::filesystem::path& path() const { return path_; }
  // The recording ends before its file is larger (for tests).
  void setMostBytes(std::uintmax_t most) { mostBytes_ = most; }
  static constexpr double kKeyStateSeconds = 10;  // of simulated time

 private:
  using Item =
      std::variant<Branch, RecordedFrame, KeyState, OperationEvent, RecordedSample, RecordedLedger>;
  // Items that are put together are kept together or not at all.
  void put(std::vector<Item> items);
  KeyState keyState(Moment moment, const Simulation& simulation);
  // Also the event that pieces have come off since the last ledger of the branch.
  void addLedger(std::vector<Item>& items, Moment moment, const Simulation& simulation);
  void write();
  std::string keep(const std::deque<Item>& items, bool last);

  const std::filesystem::path path_;
  FrameHashes hashes_;  // before file_, which asks for their fields
  RecordingFile file_;
  LedgerBooks books_;
  double frameRate_;
  Moment last_{-1, 0};                  // the last frame; another one is written in full
  FrameInput before_;                   // its input
  EventMemory events_;                  // of an operation with one branch
  std::vector<std::int64_t> keyFrame_;  // of the last key state, by branch
  struct LastLedger {
    std::int64_t frame = -1, pieces = 0;
  };
  std::vector<LastLedger> lastLedger_;  // by branch
  std::int64_t framesPerKey_;
  // What is kept at once is far less than the rest up to kLargestRecording.
  std::atomic<std::uintmax_t> mostBytes_ = kLargestRecording / 8 * 7;

  mutable std::mutex mutex_;  // guards all below
  std::condition_variable wake_;
  std::deque<Item> queue_;
  std::size_t queued_ = 0;  // bytes, about
  bool ending_ = false;
  struct Save {
    std::filesystem::path file;  // empty; no name: nothing is to be saved
    std::string name;            // of what it will be
    Moment moment;
    std::string failure;
  };
  Save save_;
  std::string failure_;
  std::thread thread_;
};

}  // namespace resect
