// Plays a recording, and proves it.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "base/progress.h"
#include "record/recorder.h"

namespace resect {

// A recorded operation that can be moved to any frame of any branch.
class Replay {
 public:
  explicit Replay(const std::filesystem::path& path);

  RecordingFile& file() { return file_; }
  const RecordedSetup& setup() const { return setup_; }
  Simulation& simulation() { return *simulation_; }
  std::int64_t branch() const { return branch_; }

  // Restores the latest key state before the frame and plays from there, or goes on playing if that
  // is nearer. If this program cannot restore a state that another version kept, plays from the
  // start. Throws Error if the recording does not hold that frame or is damaged.
  void goTo(std::int64_t branch, std::int64_t frame);
  // The next frame of the present branch; false at its end. `input` and `report`, if given, receive
  // the frame's input and the step's report.
  bool step(FrameInput* input = nullptr, StepReport* report = nullptr);
  // The frame that step() played last, as recorded.
  const RecordedFrame& recorded() const { return recorded_; }

 private:
  void playFromStart(std::int64_t branch);

  RecordingFile file_;
  RecordedSetup setup_;
  std::unique_ptr<Simulation> simulation_;
  std::int64_t branch_ = 0;
  FrameInput before_;
  RecordedFrame recorded_;
  StepReport report_;
};

// The first place where a replay differs from what was recorded.
struct Difference {
  std::int64_t branch = 0, frame = 0;
  std::string stage;  // of the step: the one that writes the field
  std::string what;   // a field as "organs.tissue.u", or a sentence
};

struct Verification {
  std::int64_t frames = 0, keyStates = 0, branches = 0;
  bool complete = true;  // false: the program ended before the recording did
  std::optional<Difference> first;
  std::string program;        // that recorded
  bool otherProgram = false;  // another version: its key states are not compared, all digests are
};

// Plays all branches from their first key state and compares every frame's input, state, events,
// samples and ledger, and every key state with its surface. Throws Error if the file cannot be read
// at all.
Verification verify(const std::filesystem::path& path, const Progress& progress = {});

}  // namespace resect
