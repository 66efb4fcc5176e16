// The recordings that the window makes by itself. Those of the last twenty operations are kept.
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

// Makes a recorder that writes a new file in recordingsFolder(), named by date, time and scenario.
// If the folder then has more than kKeptRecordings recordings, those written longest ago are
// removed. Throws Error if the folder cannot be written.
std::shared_ptr<Recorder> recordSession(const Scenario& scenario, const Simulation& simulation);

// The same for an operation that goes on from the recording `done`, whose file is neither changed
// nor removed.
std::shared_ptr<Recorder> recordSession(const Scenario& scenario, RecordingFile& done,
                                        const Simulation& simulation);

// Makes a watch that hands everything that happens in an operation to the recorder. The recorder
// lives as long as the watch.
OperationWatch watchOf(std::shared_ptr<Recorder> recorder);

struct SessionRecording {
  std::filesystem::path path;
  std::uintmax_t bytes = 0;
};
// The recordings in recordingsFolder(), the last written first.
std::vector<SessionRecording> sessionRecordings();

}  // namespace resect
