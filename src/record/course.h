// The course of a recorded operation: the frames that lead from its start to the end of a branch.
#pragma once

#include <cstdint>
#include <vector>

#include "record/file/recording_file.h"

namespace resect {

// The frames first + 1 to last of one branch: they lead from the state after frame `first` to the
// state after frame `last`.
struct CourseSpan {
  std::int64_t branch = 0, first = 0, last = 0;
};

// The spans that lead from the start of the operation to the end of a branch, through its ancestor
// branches. Each span begins at the frame at which the previous span ends. Empty if the recording
// has no such branch, or if no frame leads to the branch's end.
std::vector<CourseSpan> courseOf(RecordingFile& file, std::int64_t branch);

// The course that leads to a moment. If the moment's frame is 0, or if this frame is after the end
// of the moment's branch, returns the course to the end of this branch. For an attempt at a task
// that was ended in the window, pass RecordingFile::moment() as `moment`.
std::vector<CourseSpan> courseTo(RecordingFile& file, const Moment& moment);

// The part of a course from frame `first` to frame `last`. Both numbers are clamped to the course.
// If the course is not empty, the part is not empty either. If the clamped numbers are equal, the
// part is one span whose first frame equals its last frame: a single state.
std::vector<CourseSpan> partOf(std::vector<CourseSpan> course, std::int64_t first,
                               std::int64_t last);

}  // namespace resect
