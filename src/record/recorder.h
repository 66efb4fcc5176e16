// Records an operation while it happens.
//
// The thread that steps the simulation hands over each frame; a thread of the recorder's own writes
// it. When the program is killed at any moment, the file opens and holds all but the last quarter
// second. If the disk is full or the file cannot be written, the recording ends with a sentence and
// the operation goes on.
#pragma once

#include <condition_variable>
#include <deque>
#include <filesystem>
#include <mutex>
#include <string>
#include <thread>
#include <variant>
#include <vector>

#include "base/state/field_hashes.h"
#include "record/recording_file.h"

namespace resect {

// Digests of the state's fields after a step, in the order of `fields`, which is filled at the
// first call.
class FrameHashes {
 public:
  const std::vector<std::uint64_t>& of(const Simulation& simulation);
  const std::vector<std::string>& fields() const { return hashes_.paths(); }

 private:
  FieldHashes hashes_;
};

// The events of a step: contacts that begin and end, tissue removed, cut and torn, pieces that came
// off, instruments taken and put back, faults. `touching` (one flag per tool) and `pieces` are the
// observer's memory from step to step.
struct EventMemory {
  std::vector<char> touching, inHand;
};
std::vector<RecordedEvent> eventsOf(const StepReport& report, const Simulation& simulation,
                                    EventMemory& memory);
std::vector<RecordedSample> samplesOf(const StepReport& report, const Simulation& simulation);

class Recorder {
 public:
  // Creates the file; throws Error if that fails. simulation: at its start.
  Recorder(const std::filesystem::path& path, const Scenario& scenario,
           const Simulation& simulation);
  ~Recorder();  // as finish()
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  // After each step, by the thread that steps: 0.5 ms at 13 000 elastic particles, and the time of
  // Simulation::save() and stateHash() once in kKeyStateSeconds.
  void record(const FrameInput& input, const StepReport& report, const Simulation& simulation);

  // To be called when the simulation has been restored to an earlier frame of its course: a stroke
  // was taken back. What follows is a branch of its own.
  void wentBack(const Simulation& simulation);
  // To be called when the simulation has been restored to the state in which wentBack() was called
  // last (of the calls that were not answered yet): what follows is a branch, too.
  void wentForward(const Simulation& simulation);
  std::int64_t presentBranch() const { return branches_.back().number; }

  // Why nothing is recorded any more; empty while all is well.
  std::string failure() const;
  // Waits until all is written and closes the file.
  void finish();

  static constexpr double kKeyStateSeconds = 10;  // of simulated time

 private:
  using Item = std::variant<Branch, RecordedFrame, KeyState, RecordedEvent, RecordedSample>;
  void begin(std::int64_t parent, std::string name, const Simulation& simulation);
  void put(Item item);
  void putKeyState(const Simulation& simulation);
  void write();

  FrameHashes hashes_;  // before file_, which asks for their fields
  RecordingFile file_;
  EventMemory events_;
  FrameInput before_;                 // without tools: the next input is written in full
  std::vector<Branch> branches_;      // the last one is the present one
  std::vector<std::int64_t> leftAt_;  // branches that wentBack() left
  std::int64_t keyFrame_ = 0;
  std::int64_t framesPerKey_;

  mutable std::mutex mutex_;  // guards all below
  std::condition_variable wake_;
  std::deque<Item> queue_;
  std::size_t queued_ = 0;  // bytes, about
  bool ending_ = false;
  std::string failure_;
  std::thread thread_;
};

}  // namespace resect
