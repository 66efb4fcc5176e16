// Plays a recording: computes its frames again from their inputs. Also verifies that a replay gives
// the recorded states and measurements again. A key state is a recorded state of the simulation,
// from which playing can begin. A branch begins where the user went back and operated from an
// earlier moment (operation/live/branch.h).
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

  // Goes to a frame. Usually restores the last key state before this frame, and plays from there.
  // If the present frame lies between the key state and the wanted frame, plays on from the present
  // frame instead. If another version of the program recorded the key state and this version cannot
  // restore it, plays from the start. Throws Error if the recording has no such frame or is
  // damaged.
  void goTo(std::int64_t branch, std::int64_t frame);
  // Plays the next frame of the present branch. Returns false if the branch has no further frame.
  // `input` and `report`, if given, receive the frame's input and the step's report.
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

// The first difference between a replay and the recording.
struct Difference {
  std::int64_t branch = 0, frame = 0;
  // If a field differs: the stage of the step that writes this field. If the surface differs:
  // "updateSurface". If the state has a field that the recording lacks: "step". If an event, a
  // sample or a ledger differs: "measure". If the recording is damaged: "file".
  std::string stage;
  std::string what;  // the field, such as "organs.tissue.u", or a description
};

struct Verification {
  std::int64_t frames = 0, keyStates = 0, branches = 0;
  bool complete = true;  // RecordingFile::complete()
  std::optional<Difference> first;
  std::string program;        // program that made the recording, with its version
  bool otherProgram = false;  // made by another version; key states are not compared
};

// Plays every branch from its first key state, and stops at the first difference. Compares the
// digests of every frame's input and state; all samples, ledgers and key states; and the surface at
// each key state. Compares all events except events of sight (operation/live/sight.h), which cannot
// be computed again. Throws Error if the file cannot be opened (RecordingFile::open()) or its setup
// cannot be run.
Verification verify(const std::filesystem::path& path, const Progress& progress = {});

}  // namespace resect
