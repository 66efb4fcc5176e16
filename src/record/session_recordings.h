// The recordings that the window makes by itself: the last twenty operations.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "operation/live/live_operation.h"
#include "record/recorder.h"

namespace resect {

inline constexpr int kKeptRecordings = 20;

// $XDG_STATE_HOME/resect/recordings, or ~/.local/state/resect/recordings.
std::filesystem::path recordingsFolder();

// A recorder into a new file of that folder, named by date, time and scenario. Beyond
// kKeptRecordings those are removed that were written longest ago. Throws Error if the folder
// cannot be written.
std::shared_ptr<Recorder> recordSession(const Scenario& scenario, const Simulation& simulation);

// The same for an operation that goes on from a recording, which stays as it is.
std::shared_ptr<Recorder> recordSession(const Scenario& scenario, RecordingFile& done,
                                        const Simulation& simulation);

// Hands what happens in an operation to the recorder, which lives as long as the watch.
OperationWatch watchOf(std::shared_ptr<Recorder> recorder);

struct SessionRecording {
  std::filesystem::path path;
  std::uintmax_t bytes = 0;
};
// What is in the folder, the last written first.
std::vector<SessionRecording> sessionRecordings();

}  // namespace resect
