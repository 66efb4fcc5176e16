#include "record/export/moments.h"

#include <algorithm>
#include <cmath>

namespace resect {

bool isDue(std::int64_t frame, double frameRate, const ExportedPart& part) {
  if (part.rate <= 0 || frame == part.course.back().last) return true;
  const auto passed = [&](std::int64_t f) {
    return std::floor(double(f) / frameRate * part.rate + 1e-9);
  };
  return passed(frame) > passed(frame - 1);
}

void playMoments(Replay& replay, const ExportedPart& part, bool withLook,
                 const std::function<void(const Simulation&)>& visit, const Progress& progress,
                 const std::function<void(const StepReport&)>& each) {
  const double frameRate = replay.setup().scenario.frameRate;
  const std::int64_t first = part.course.front().first, end = part.course.back().last;
  Simulation& simulation = replay.simulation();
  if (withLook) simulation.keepLook();
  replay.goTo(part.course.front().branch, first);
  visit(simulation);
  StepReport step;
  for (const CourseSpan& span : part.course) {
    if (replay.branch() != span.branch) replay.goTo(span.branch, span.first);
    while (simulation.frame() < span.last && replay.step(nullptr, &step)) {
      if (each) each(step);
      if (isDue(simulation.frame(), frameRate, part)) visit(simulation);
      report(progress,
             double(simulation.frame() - first) / double(std::max<std::int64_t>(1, end - first)));
    }
  }
}

}  // namespace resect
