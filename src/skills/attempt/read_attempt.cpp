#include "skills/attempt/read_attempt.h"

#include <algorithm>

#include "base/error.h"
#include "io/scenario/task_reader.h"
#include "operation/live/sight.h"
#include "record/course.h"
#include "skills/attempt/attempt_reader.h"

namespace resect {
namespace {

std::optional<Task> taskOf(RecordingFile& file, const RecordedSetup& setup,
                           const AttemptOptions& options) {
  if (options.task) return options.task;
  const std::string text = file.task();
  if (text.empty()) return {};
  return parseTask(text, file.name() + ", its task", setup.scenario);
}

// Adds up for how long the tips were outside the picture on the way through a span.
void addSight(RecordingFile& file, const CourseSpan& span, double interval, Attempt& attempt) {
  std::vector<std::optional<std::int64_t>> since(attempt.instruments.size());
  const auto seen = [&](std::size_t tool, std::int64_t frame) {
    if (!since[tool]) return;
    *attempt.instruments[tool].unseen += interval * double(frame - *since[tool]);
    since[tool].reset();
  };
  for (const OperationEvent& event : file.events(span.branch)) {
    if (event.tool < 0 || std::size_t(event.tool) >= since.size()) continue;
    if (event.frame <= span.first || event.frame > span.last) continue;
    const auto tool = std::size_t(event.tool);
    if (isSight(event) || event.kind == "put_back") seen(tool, event.frame);
    if (!isSight(event)) continue;
    std::optional<double>& unseen = attempt.instruments[tool].unseen;
    if (!unseen) unseen = 0;
    if (event.kind == kOutOfView) since[tool] = event.frame;
  }
  for (std::size_t tool = 0; tool < since.size(); ++tool) seen(tool, span.last);
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
  for (const CourseSpan& span : course) addSight(file, span, attempt.interval, attempt);
  reader.finish(simulation);
  reader.measureMargins(simulation);
  return attempt;
}

}  // namespace resect
