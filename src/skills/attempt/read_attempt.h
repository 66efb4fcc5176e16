// Makes an attempt from a recording, by playing it: its frames are computed again.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "base/progress.h"
#include "record/replay.h"
#include "skills/attempt/attempt.h"

namespace resect {

struct AttemptOptions {
  std::optional<Task> task;  // task that replaces the task of the recording
  std::string learner;       // pseudonym
  // Called at the start and after each frame, for example to draw a picture. time: s.
  std::function<void(const Scenario&, Simulation&, double time)> watch;
};

// Plays the frames that lead from the start of the operation to RecordingFile::moment(), usually
// the end of the recording. Throws Error if the file is no recording or is damaged, if it holds no
// frames, or if its organs lack what the task names. Takes as long as the computation of the
// recorded operation took.
Attempt readAttempt(const std::filesystem::path& path, const AttemptOptions& options = {},
                    const Progress& progress = {});

}  // namespace resect
