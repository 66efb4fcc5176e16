// Makes an operation from a recording, so that the operation can be continued.
#pragma once

#include "base/progress.h"
#include "operation/live/operation_history.h"
#include "record/file/recording_file.h"

namespace resect {

struct RecordedOperation {
  RecordedSetup setup;
  std::unique_ptr<Simulation> simulation;  // in the state at the moment history.now()
  OperationHistory history;
};

// The operation at the end of `branch`. If no `branch` is given, the operation at
// RecordingFile::moment(). setup: file.setup(). mostBytes: largest memory for the states that the
// history keeps. Throws Error if the recording is damaged or has no such branch.
RecordedOperation operationOf(RecordingFile& file, RecordedSetup setup,
                              std::optional<std::int64_t> branch = {},
                              const Progress& progress = {},
                              std::size_t mostBytes = std::size_t(512) << 20);

}  // namespace resect
