// Branches: the different courses that an operation has taken. Branch 0 is the first. Each further
// branch begins at an earlier moment: the user went back to this moment and went on operating.
#pragma once

#include <cstdint>
#include <limits>
#include <string>

namespace resect {

inline constexpr const char* kFirstBranch = "0, from the start";  // name of branch 0

struct Branch {
  std::int64_t number = 0, parent = -1;  // parent: number of the parent branch; -1: none
  std::int64_t from = 0;                 // frame of the parent at which this branch begins
  std::string name;
};

// The end of a frame of a branch. Frames are numbered from 1: the number of a frame is the value of
// Simulation::frame() after the step that computes the frame. 0 stands for the start.
struct Moment {
  std::int64_t branch = 0, frame = 0;
  bool operator==(const Moment&) const = default;
};

// This value of Moment::frame stands for the last frame of the branch (Recorder::saveAs()).
inline constexpr std::int64_t kEndOfBranch = std::numeric_limits<std::int64_t>::max();

}  // namespace resect
