// An overview of an operation's history, for showing it to people.
//
// The way to the end of a branch consists of all frames that led to this end: the branch's own
// frames; the frames of its parent up to the frame at which the branch begins; and so on, back to
// the start of the operation.
#pragma once

#include <vector>

#include "operation/live/operation_history.h"

namespace resect {

struct Timeline {
  struct Course {
    Branch branch;
    std::int64_t end = 0;  // number of its last frame
    std::vector<Stroke> strokes;
    std::vector<std::int64_t> faults;  // numbers of the frames in which faults occurred
    // As in OperationHistory::Course.
    double removedVolume = 0, piecesVolume = 0, cut = 0, bared = 0;
    std::int64_t pieces = 0;
    double force = 0;  // largest force on any tool on the way to the branch's end, N
  };
  std::vector<Course> courses;  // one per branch, by number

  // The moment at the end of frame `frame`, on the way to the end of `branch`.
  Moment momentOn(std::int64_t branch, std::int64_t frame) const;
  // Whether the moment is on the way to the end of `branch`.
  bool leadsTo(std::int64_t branch, Moment moment) const;
  std::size_t strokeCount() const;  // in all branches
  // The strokes, and the frames with faults, on the way to the end of `branch`, in order.
  std::vector<Stroke> strokesOn(std::int64_t branch) const;
  std::vector<std::int64_t> faultsOn(std::int64_t branch) const;

 private:
  template <typename Visit>
  void walkBack(std::int64_t branch, const Visit& visit) const;
};

Timeline timelineOf(const OperationHistory& history);

}  // namespace resect
