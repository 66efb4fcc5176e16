// The course of a recorded operation: the frames that lead from its start to the end of a branch.
#pragma once

#include <cstdint>
#include <vector>

#include "record/file/recording_file.h"

namespace resect {

// Frames of one branch, from the state `first` to the state `last`.
struct CourseSpan {
  std::int64_t branch = 0, first = 0, last = 0;
};

// The spans that lead to the end of a branch, through the branches before it: each begins at the
// frame at which the one before ends. Empty: the recording has no such branch, or no frames in it.
std::vector<CourseSpan> courseOf(RecordingFile& file, std::int64_t branch);

// The part of a course from one frame to another; both are clamped to the course's ends. At least
// one span, which may be of one state, if the course has any.
std::vector<CourseSpan> partOf(std::vector<CourseSpan> course, std::int64_t first,
                               std::int64_t last);

}  // namespace resect
