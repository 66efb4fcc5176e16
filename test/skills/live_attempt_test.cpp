// What a learner is told while the attempt goes on.
#include "skills/live/live_attempt.h"

#include <doctest/doctest.h>

#include "io/data_folder.h"
#include "io/operation_setup.h"
#include "io/plain_mesh.h"
#include "io/scenario/scenario_file.h"
#include "record/session_recordings.h"
#include "skills/attempt/read_attempt.h"
#include "skills/live/next_step.h"
#include "skills/score/verdict.h"
#include "support/temporary_folder.h"

using namespace resect;
using test::TemporaryFolder;

namespace {

Scenario taskAt(const std::string& name, std::optional<double> spacing) {
  Scenario scenario = readScenario(dataFolder() / "tasks" / (name + ".toml"));
  if (spacing) setSpacing(scenario, *scenario.organs[0].source.spacing, *spacing);
  return scenario;
}

// The reference run of a task, and a live attempt that is told of it.
struct Run {
  Scenario scenario;
  Simulation simulation;
  std::shared_ptr<LiveAttempt> attempt;
  OperationWatch watch;
  std::int64_t frame = 0, branch = 0;

  explicit Run(const std::string& task) : Run(taskAt(task, {})) {}
  Run(const std::string& task, double spacing) : Run(taskAt(task, spacing)) {}
  explicit Run(Scenario of)
      : scenario(std::move(of)),
        simulation(makeSimulation(scenario, readPlainMesh)),
        attempt(std::make_shared<LiveAttempt>(scenario, simulation)),
        watch(attempt->watch({})) {}

  void play(double until) {
    StepReport report;
    for (; frame < std::int64_t(until * scenario.frameRate); ++frame) {
      const FrameInput input = frameInput(scenario, frame);
      simulation.step(input, report);
      watch.stepped({branch, frame + 1}, input, report, {}, simulation);
    }
  }
};

}  // namespace

TEST_CASE("targets are done one after the other, and work that is taken back counts no more") {
  Run run("touch-and-hold");
  CHECK(run.attempt->progress().time == 0);
  run.play(1);
  const AttemptProgress begun = run.attempt->progress();
  CHECK(begun.next == "Touch target 1 of 4.");
  CHECK(begun.target == 0);
  CHECK(begun.places.size() == 4);
  const Bytes second = run.simulation.save();
  run.play(5);
  const AttemptProgress later = run.attempt->progress();
  CHECK(later.target == 1);
  CHECK_FALSE(later.reached);
  CHECK((later.places[0] - begun.places[0]).norm() < 0.02);  // the tissue gives way
  CHECK((later.places[0] - begun.places[0]).norm() > 1e-5);

  run.simulation.restore(second);
  run.frame = 60, run.branch = 1;
  run.watch.began({1, 0, 60, "back"}, run.simulation);
  run.play(2);
  CHECK(run.attempt->progress().target == 0);
  run.play(15.4);
  CHECK(run.attempt->progress().reached);
  CHECK(run.attempt->progress().next.find("rest") != std::string::npos);

  // Where it has not been, it says nothing new.
  const double last = run.attempt->progress().time;
  run.watch.began({3, 0, 10, "beside"}, run.simulation);
  StepReport report;
  run.simulation.step(frameInput(run.scenario, 0), report);
  run.watch.stepped({3, 11}, {}, report, {}, run.simulation);
  CHECK(run.attempt->progress().time == last);
}

TEST_CASE("an attempt that has ended is scored at once as from its recording") {
  for (const char* task : {"touch-and-hold", "control-bleeding"}) {
    CAPTURE(task);
    const TemporaryFolder folder;
    const std::filesystem::path path = folder / "attempt.resect";
    Run run(task, 0.014);
    const auto recorder = std::make_shared<Recorder>(path, run.scenario, run.simulation);
    run.watch = run.attempt->watch(watchOf(recorder));
    run.play(run.scenario.duration);
    const std::int64_t last = run.frame - 30;  // the rest does not count
    recorder->saveAs(folder / "saved.resect", {0, last});
    std::optional<Attempt> now = run.attempt->end(last, run.simulation);
    REQUIRE(now);
    const Scored live = score(std::move(*now));
    const Scored kept = score(readAttempt(folder / "saved.resect"));
    CHECK(live.attempt.time.size() == std::size_t(last));
    CHECK(live.verdict.passed == kept.verdict.passed);
    CHECK(live.verdict.score == kept.verdict.score);
    CHECK(live.verdict.reason == kept.verdict.reason);
    CHECK(live.verdict.good == kept.verdict.good);
    REQUIRE(live.verdict.deductions.size() == kept.verdict.deductions.size());
    for (std::size_t i = 0; i < live.verdict.deductions.size(); ++i)
      CHECK(live.verdict.deductions[i].fact == kept.verdict.deductions[i].fact);
    REQUIRE(live.measures.size() == kept.measures.size());
    for (std::size_t i = 0; i < live.measures.size(); ++i) {
      CAPTURE(live.measures[i].measure);
      CHECK(live.measures[i].measure == kept.measures[i].measure);
      CHECK(live.measures[i].value == doctest::Approx(kept.measures[i].value).epsilon(1e-6));
    }
    CHECK_FALSE(run.attempt->end(1, run.simulation));
  }
}

TEST_CASE("the next step follows what was done") {
  Attempt attempt;
  attempt.interval = 0.1;
  attempt.task.emplace();
  attempt.task->steps = {"Cut across the branch."};
  attempt.bleeds = true;
  attempt.tissue = {{}};
  for (int f = 1; f <= 50; ++f) attempt.time.push_back(0.1 * f);
  attempt.bled.assign(50, 0);
  TaskGoal& goal = attempt.task->goal;
  const auto next = [&] { return nextStep(attempt, goalResult(attempt)); };

  goal.kind = TaskGoal::Kind::StopBleeding;
  CHECK(next() == "Cut across the branch.");
  for (std::size_t f = 0; f < 50; ++f) attempt.bled[f] = 1e-7 * double(f);  // 1 ml/s
  CHECK(next() == "Stop the bleeding of 60 ml/min.");
  goal.from = 100e-6 / 60;
  CHECK(next() == "It does not bleed enough yet: 60 of 100 ml/min. Cut across the branch.");
  for (std::size_t f = 0; f < 50; ++f) attempt.bled[f] = 1e-9;  // and even while it is dry
  CHECK(next().starts_with("It does not bleed enough yet"));

  goal.kind = TaskGoal::Kind::Divide;
  CHECK(next().find("on the side of the heart") != std::string::npos);
  attempt.clips.push_back({});
  CHECK(next().find("second clip") != std::string::npos);
  attempt.clips.push_back({});
  CHECK(next() == "Cut the vessel between the clips.");

  goal.kind = TaskGoal::Kind::Follow;
  goal.holdWith = "hook";
  attempt.goal.lineLength = 0.1;
  CHECK(next().find("Hold the tissue with the hook") != std::string::npos);
  attempt.goal.held.assign(50, 1);
  CHECK(next() == "Cut along the line, from one end to the other.");
  attempt.goal.work = {{10, 0, 0}, {11, 0.02, 0}, {12, 0.05, 0}};
  CHECK(next() == "Go on along the line: 51 % done; missing: 51 to 100 mm.");
  attempt.goal.work = {{10, 0, 0}, {11, 0.05, 0}, {12, 0.1, 0}, {13, 0.1, 0.021}};
  CHECK(next().find("too far from the line") != std::string::npos);

  goal.kind = TaskGoal::Kind::Resect;
  goal.structure = "tumour";
  CHECK(next() == "Cut round the tumour, at least 10 mm away from it.");
  attempt.tissue.back().cut = 1e-4;
  CHECK(next() == "Go on until the piece with the tumour comes off.");
}
