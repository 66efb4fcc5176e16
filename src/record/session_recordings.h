// The recordings that the window makes automatically. The recordings of the last kKeptRecordings
// operations are kept.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "operation/live/live_operation.h"
#include "record/recorder.h"

namespace resect {

inline constexpr int kKeptRecordings = 20;

// $XDG_STATE_HOME/resect/recordings, or ~/.local/state/resect/recordings if XDG_STATE_HOME is not
// set.
std::filesystem::path recordingsFolder();

// Makes a recorder that writes a new file in recordingsFolder(). The file's name contains the date,
// the time and the scenario's name. If the folder then has more than kKeptRecordings recordings,
// the oldest are removed. Throws Error if the folder cannot be written.
std::shared_ptr<Recorder> recordSession(const Scenario& scenario, const Simulation& simulation);

// As above, for an operation that continues the recording `done`. The file of `done` is neither
// changed nor removed.
std::shared_ptr<Recorder> recordSession(const Scenario& scenario, RecordingFile& done,
                                        const Simulation& simulation);

// Makes a watch, a set of callbacks, that passes the frames and events of a live operation to the
// recorder. The watch keeps the recorder alive.
OperationWatch watchOf(std::shared_ptr<Recorder> recorder);

struct SessionRecording {
  std::filesystem::path path;
  std::uintmax_t bytes = 0;
};
// The recordings in recordingsFolder(), the most recently written first.
std::vector<SessionRecording> sessionRecordings();

}  // namespace resect
