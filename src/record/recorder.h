// Records an operation while it happens.
//
// The thread that steps the simulation hands each frame to the recorder, and the recorder's own
// thread writes the frame. If the program is killed, the file can still be opened; at most the last
// quarter of a second is missing from it. If the file cannot be written, for example because the
// disk is full or too slow, the recording ends but the operation goes on. failure() then says why
// the recording ended.
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

// The name and version of this program, as in RecordingInfo.
std::string programName();

// Digests of the fields of the simulation's state after a step, in the order of fields().
class FrameHashes {
 public:
  // Computes digests of the fields that the state of `start` has. start: a simulation at the start
  // of its operation.
  explicit FrameHashes(const Simulation& start);
  // fields: names of the state's fields, as in RecordingInfo::fields.
  explicit FrameHashes(std::vector<std::string> fields) : hashes_(std::move(fields)) {}
  const std::vector<std::uint64_t>& of(const Simulation& simulation);
  const std::vector<std::string>& fields() const { return hashes_.paths(); }
  // Whether of() has met a field that is not among fields().
  bool strange() const { return hashes_.strange(); }

 private:
  FieldHashes hashes_;
};

// One sample for each tool in hand, after the step that `report` describes. RecordedSample::branch
// is not set.
std::vector<RecordedSample> samplesOf(const StepReport& report, const Simulation& simulation);

class Recorder {
 public:
  // Creates the file; throws Error if that fails. Branch 0 begins at the present state of
  // `simulation`, which must be at the start of its operation.
  Recorder(const std::filesystem::path& path, const Scenario& scenario,
           const Simulation& simulation);
  // Creates a file with a copy of everything in `done`, for an operation that continues `done`.
  // Later frames are added to the new file. Throws Error if the file cannot be created. Also throws
  // Error if the state of `simulation` has a field that `done` lacks; this can happen if another
  // version of the program made `done`.
  Recorder(const std::filesystem::path& path, RecordingFile& done, const Scenario& scenario,
           const Simulation& simulation);
  ~Recorder();  // calls finish()
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  // begin(), rename(), stood() and record() must be called by the thread that steps the simulation.
  // begin() records that a branch begins at the present state of `simulation`. rename() records
  // that a branch has a new name. If the user goes back and operates from an earlier moment, a new
  // branch begins (operation/live/branch.h).
  void begin(const Branch& branch, const Simulation& simulation);
  void rename(const Branch& branch);
  // To be called when operating pauses at the end of a branch. Records the ledger of this moment,
  // an account of all tissue (operation/ledger/ledger.h).
  void stood(Moment moment, const Simulation& simulation);
  // To be called after each step. The frame must follow the last frame of its branch. Cost: 0.5 ms
  // with 13 000 elastic particles. Once in kKeyStateSeconds a key state is stored too: a state from
  // which playing can begin. This adds the times of Simulation::save() and Simulation::stateHash().
  void record(Moment moment, const FrameInput& input, const StepReport& report,
              std::span<const OperationEvent> events, const Simulation& simulation);
  // As above, for an operation that has only branch 0.
  void record(const FrameInput& input, const StepReport& report, const Simulation& simulation);

  // Why the recording has ended; empty while it goes on.
  std::string failure() const;
  // Present size of the file and its write-ahead log together, bytes.
  std::uintmax_t size() const;
  // Writes everything recorded so far to `path`, as a finished recording, and waits until that is
  // done. A file at `path` is replaced, but only when the new file is complete. Throws Error if the
  // file cannot be written. Also throws Error if the recording has ended (failure()); the file at
  // `path` then holds everything recorded until that end. moment: the present moment of the
  // operation, which RecordingFile::moment() will return. The moment's frame may be kEndOfBranch.
  void saveAs(const std::filesystem::path& path, Moment moment);
  // Waits until everything is written, and closes the file.
  void finish();

  const std::filesystem::path& path() const { return path_; }
  // The recording ends as soon as size() is larger than `most` (for tests).
  void setMostBytes(std::uintmax_t most) { mostBytes_ = most; }
  static constexpr double kKeyStateSeconds = 10;  // of simulated time

 private:
  using Item =
      std::variant<Branch, RecordedFrame, KeyState, OperationEvent, RecordedSample, RecordedLedger>;
  // Queues items. All items of one call are written in the same transaction.
  void put(std::vector<Item> items);
  KeyState keyState(Moment moment, const Simulation& simulation);
  // Appends the ledger, and the event "piece" if pieces came off since the branch's last ledger.
  void addLedger(std::vector<Item>& items, Moment moment, const Simulation& simulation);
  void write();
  std::string keep(const std::deque<Item>& items, bool last);

  const std::filesystem::path path_;
  FrameHashes hashes_;  // declared before file_, which is initialised with hashes_.fields()
  RecordingFile file_;
  LedgerBooks books_;
  double frameRate_;
  // The last recorded frame. A frame that follows it is written as changes of the input, any other
  // frame with its whole input.
  Moment last_{-1, 0};
  FrameInput before_;                   // input of the frame last_, without edits
  EventMemory events_;                  // for record() without events
  std::vector<std::int64_t> keyFrame_;  // per branch: frame of its last key state
  struct LastLedger {
    std::int64_t frame = -1, pieces = 0;
  };
  std::vector<LastLedger> lastLedger_;  // per branch
  std::int64_t framesPerKey_;
  // size() is compared with this limit after each transaction. The transaction that exceeds the
  // limit fits into the remaining eighth of kLargestRecording.
  std::atomic<std::uintmax_t> mostBytes_ = kLargestRecording / 8 * 7;

  mutable std::mutex mutex_;  // guards all members below
  std::condition_variable wake_;
  std::deque<Item> queue_;
  std::size_t queued_ = 0;  // approximate size of the queue, bytes
  bool ending_ = false;
  struct Save {
    std::filesystem::path file;  // an empty file to write to; "": nothing is to be saved
    std::string name;            // the final name of the file, for messages
    Moment moment;
    std::string failure;
  };
  Save save_;
  std::string failure_;
  std::thread thread_;
};

}  // namespace resect
