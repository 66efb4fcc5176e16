#include "record/course.h"

#include <algorithm>
#include <utility>

namespace resect {

std::vector<CourseSpan> courseOf(RecordingFile& file, std::int64_t branch) {
  const std::vector<Branch> branches = file.branches();
  std::vector<CourseSpan> course;
  std::int64_t end = file.lastFrame(branch);
  while (branch >= 0 && branch < std::int64_t(branches.size())) {
    const Branch& one = branches[std::size_t(branch)];
    if (end > one.from) course.insert(course.begin(), {branch, one.from, end});
    end = one.from;
    branch = one.parent < branch ? one.parent : -1;
  }
  return course;
}

std::vector<CourseSpan> courseTo(RecordingFile& file, const Moment& moment) {
  std::vector<CourseSpan> course = courseOf(file, moment.branch);
  return moment.frame > 0 ? partOf(std::move(course), 0, moment.frame) : course;
}

std::vector<CourseSpan> partOf(std::vector<CourseSpan> course, std::int64_t first,
                               std::int64_t last) {
  if (course.empty()) return course;
  first = std::clamp(first, course.front().first, course.back().last);
  last = std::clamp(last, first, course.back().last);
  std::vector<CourseSpan> part;
  for (CourseSpan span : course) {
    span.first = std::max(span.first, first);
    span.last = std::min(span.last, last);
    // Of a single state: the first span that holds it.
    if (span.first < span.last || (first == last && span.first == span.last && part.empty()))
      part.push_back(span);
  }
  return part;
}

}  // namespace resect
