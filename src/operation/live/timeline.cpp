#include "operation/live/timeline.h"

#include <algorithm>

namespace resect {

// The branches of the way, the last first, each with the last of its frames on it.
template <typename Visit>
void Timeline::walkBack(std::int64_t branch, const Visit& visit) const {
  std::int64_t last = courses[std::size_t(branch)].end;
  for (std::int64_t b = branch; b >= 0; b = courses[std::size_t(b)].branch.parent) {
    const Course& course = courses[std::size_t(b)];
    visit(course, last);
    last = std::min(last, course.branch.from);
  }
}

Moment Timeline::momentOn(std::int64_t branch, std::int64_t frame) const {
  Moment moment{branch, frame};
  // A branch's first state is its parent's.
  while (moment.branch > 0 && frame <= courses[std::size_t(moment.branch)].branch.from)
    moment.branch = courses[std::size_t(moment.branch)].branch.parent;
  return moment;
}

bool Timeline::leadsTo(std::int64_t branch, Moment moment) const {
  bool found = false;
  walkBack(branch, [&](const Course& course, std::int64_t last) {
    found |= course.branch.number == moment.branch && moment.frame <= last;
  });
  return found;
}

std::size_t Timeline::strokeCount() const {
  std::size_t count = 0;
  for (const Course& course : courses) count += course.strokes.size();
  return count;
}

std::vector<Stroke> Timeline::strokesOn(std::int64_t branch) const {
  std::vector<Stroke> strokes;
  walkBack(branch, [&](const Course& course, std::int64_t last) {
    for (auto s = course.strokes.rbegin(); s != course.strokes.rend(); ++s)
      if (s->from < last) strokes.push_back(*s), strokes.back().to = std::min(s->to, last);
  });
  std::ranges::reverse(strokes);
  return strokes;
}

std::vector<std::int64_t> Timeline::faultsOn(std::int64_t branch) const {
  std::vector<std::int64_t> faults;
  walkBack(branch, [&](const Course& course, std::int64_t last) {
    for (auto f = course.faults.rbegin(); f != course.faults.rend(); ++f)
      if (*f <= last) faults.push_back(*f);
  });
  std::ranges::reverse(faults);
  return faults;
}

Timeline timelineOf(const OperationHistory& history) {
  Timeline timeline;
  for (const OperationHistory::Course& c : history.courses()) {
    double force = 0;
    if (!c.peaks.empty() && !c.peaks.back().second.empty())
      force = std::ranges::max(c.peaks.back().second);
    timeline.courses.push_back({c.branch, c.end(), c.strokes.strokes(), c.faults, c.removedVolume,
                                c.piecesVolume, c.cut, c.bared, c.pieces, force});
  }
  return timeline;
}

}  // namespace resect
