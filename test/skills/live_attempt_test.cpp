// What a learner is told while the attempt goes on.
#include "skills/live/live_attempt.h"

#include <doctest/doctest.h>

#include "io/data_folder.h"
#include "io/operation_setup.h"
#include "io/plain_mesh.h"
#include "io/scenario/scenario_file.h"
#include "skills/live/next_step.h"

using namespace resect;

namespace {

// The reference run of a task, and a live attempt that is told of it.
struct Run {
  Scenario scenario;
  Simulation simulation;
  std::shared_ptr<LiveAttempt> attempt;
  OperationWatch watch;
  std::int64_t frame = 0, branch = 0;

  explicit Run(const std::string& task)
      : scenario(readScenario(dataFolder() / "tasks" / (task + ".toml"))),
        simulation(makeSimulation(scenario, readPlainMesh)),
        attempt(std::make_shared<LiveAttempt>(scenario, simulation)),
        watch(attempt->watch({})) {}

  void play(double until) {
    StepReport report;
    for (; frame < std::int64_t(until * scenario.frameRate); ++frame) {
      simulation.step(frameInput(scenario, frame), report);
      watch.stepped({branch, frame + 1}, {}, report, {}, simulation);
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
