#include "skills/attempt/read_attempt.h"

#include <algorithm>

#include "base/error.h"
#include "io/scenario/task_reader.h"
#include "record/course.h"
#include "skills/attempt/attempt_reader.h"
#include "skills/attempt/unseen.h"

namespace resect {
namespace {

std::optional<Task> taskOf(RecordingFile& file, const RecordedSetup& setup,
                           const AttemptOptions& options) {
  if (options.task) return options.task;
  const std::string text = file.task();
  if (text.empty()) return {};
  return parseTask(text, file.name() + ", its task", setup.scenario);
}

}  // namespace

Attempt readAttempt(const std::filesystem::path& path, const AttemptOptions& options,
                    const Progress& progress) {
  Replay replay(path);
  RecordingFile& file = replay.file();
  const RecordedSetup& setup = replay.setup();
  Attempt attempt;
  attempt.file = path.string();
  attempt.title = setup.scenario.title;
  attempt.scenario = setup.scenario.name;
  attempt.program = file.info().program;
  attempt.learner = options.learner;
  attempt.complete = file.complete();
  attempt.task = taskOf(file, setup, options);
  attempt.undos = int(std::max<std::size_t>(1, file.branches().size())) - 1;
  const std::vector<CourseSpan> course = courseTo(file, file.moment());
  if (course.empty())
    throw error("{}: holds no frames, so there is no attempt to score; record one", path.string());

  Simulation& simulation = replay.simulation();
  if (options.watch) simulation.keepLook();
  replay.goTo(course.front().branch, course.front().first);
  AttemptReader reader(attempt, setup.scenario, simulation);
  if (options.watch) options.watch(setup.scenario, simulation, 0);
  StepReport step;
  const double end = double(std::max<std::int64_t>(1, course.back().last));
  for (const CourseSpan& span : course) {
    if (replay.branch() != span.branch) replay.goTo(span.branch, span.first);
    while (simulation.frame() < span.last && replay.step(nullptr, &step)) {
      reader.add(simulation, step);
      if (options.watch) options.watch(setup.scenario, simulation, simulation.time());
      report(progress, double(simulation.frame()) / end);
    }
  }
  for (const CourseSpan& span : course)
    addUnseen(file.events(span.branch), span.first, span.last, attempt);
  reader.finish(simulation);
  reader.measureMargins(simulation);
  return attempt;
}

}  // namespace resect
