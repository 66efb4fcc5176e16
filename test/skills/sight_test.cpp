// Tips that nobody saw, and structures that were hurt: from the operation to the measures.
#include "operation/live/sight.h"

#include <doctest/doctest.h>

#include "io/data_folder.h"
#include "io/operation_setup.h"
#include "io/plain_mesh.h"
#include "io/scenario/scenario_file.h"
#include "record/recorder.h"
#include "record/replay.h"
#include "skills/attempt/attempt_reader.h"
#include "skills/attempt/read_attempt.h"
#include "skills/score/verdict.h"
#include "support/temporary_folder.h"

using namespace resect;

namespace {

Scenario coarse(const std::string& folder, const std::string& name) {
  Scenario scenario = readScenario(findDataFile(name, folder, ".toml"));
  setSpacing(scenario, *scenario.organs[0].source.spacing, 0.014);
  return scenario;
}

// Records `frames` frames of the scenario; sight(frame): whether the tips are seen.
template <typename Seen>
void record(Scenario scenario, const std::filesystem::path& path, int frames, const Seen& sight) {
  Simulation simulation = makeSimulation(scenario, readPlainMesh);
  Recorder recorder(path, scenario, simulation);
  EventMemory memory;
  std::vector<Sight> said;
  StepReport report;
  for (int i = 0; i < frames; ++i) {
    const FrameInput input = frameInput(scenario, i);
    simulation.step(input, report);
    std::vector<OperationEvent> events = eventsOf(report, simulation, memory);
    for (const OperationEvent& event :
         sightEvents(std::vector<Sight>(scenario.tools.size(), sight(simulation.frame())),
                     simulation, said))
      events.push_back(event);
    recorder.record({0, simulation.frame()}, input, report, events, simulation);
  }
  recorder.stood({0, simulation.frame()}, simulation);
  recorder.finish();
}

}  // namespace

TEST_CASE("the time in which nobody saw the tip is kept, and the recording stays proved") {
  const test::TemporaryFolder folder;
  const Scenario scenario = coarse("tasks", "touch-and-hold");
  record(scenario, folder / "seen.resect", 300, [](std::int64_t frame) {
    return frame >= 100 && frame < 160 ? Sight::Unseen : Sight::Seen;
  });
  CHECK(!verify(folder / "seen.resect").first);
  const Scored scored = score(readAttempt(folder / "seen.resect"));
  CHECK(*valueOf(scored.measures, "out_of_view_s") == doctest::Approx(1));
  int instruments = 0;
  for (const InstrumentRecord& one : scored.attempt.instruments) instruments += bool(one.unseen);
  CHECK(instruments == 1);  // the one that was in hand

  record(scenario, folder / "end.resect", 300,
         [](std::int64_t frame) { return frame >= 240 ? Sight::Unseen : Sight::Seen; });
  CHECK(*valueOf(score(readAttempt(folder / "end.resect")).measures, "out_of_view_s") ==
        doctest::Approx(1));

  record(scenario, folder / "nobody.resect", 120, [](std::int64_t) { return Sight::Unknown; });
  CHECK(!valueOf(score(readAttempt(folder / "nobody.resect")).measures, "out_of_view_s"));
}

TEST_CASE("what comes after the moment at which the window ended an attempt does not count") {
  const test::TemporaryFolder folder;
  const Scenario scenario = coarse("tasks", "touch-and-hold");
  record(scenario, folder / "all.resect", 300,
         [](std::int64_t frame) { return frame >= 200 ? Sight::Unseen : Sight::Seen; });
  CHECK(readAttempt(folder / "all.resect").duration() == doctest::Approx(5));
  RecordingFile all = RecordingFile::open(folder / "all.resect");
  std::ofstream(folder / "ended.resect").close();
  all.copyTo(folder / "ended.resect", "ended.resect", Moment{0, 240});
  const Attempt ended = readAttempt(folder / "ended.resect");
  CHECK(ended.duration() == doctest::Approx(4));
  double unseen = 0;
  for (const InstrumentRecord& one : ended.instruments) unseen += one.unseen.value_or(0);
  CHECK(unseen == doctest::Approx(40 / 60.0));
}

TEST_CASE("the wound with which an exercise begins is known before the first step") {
  Scenario scenario = coarse("tasks", "control-bleeding");
  Simulation simulation = makeSimulation(scenario, readPlainMesh);
  Attempt attempt;
  attempt.task = scenario.task;
  AttemptReader reader(attempt, scenario, simulation);
  REQUIRE(!attempt.vessels.empty());
  for (const VesselStory& v : attempt.vessels) {
    CHECK(v.before);
    CHECK(v.cut == 0);
    CHECK(!v.name.empty());
  }
}

TEST_CASE("structures beside the goal's that were cut are told by name") {
  const test::TemporaryFolder folder;
  Scenario scenario = coarse("scenarios", "incise");
  const auto ball = [](int label, const char* name, const Vec3& centre, double radius) {
    OrganLabel made{label, name, {}};
    made.region.shape = Region::Shape::Ball;
    made.region.frame = Region::Frame::Organ;
    made.region.centre = centre, made.region.radius = radius;
    return made;
  };
  // The incision goes over the dome.
  scenario.organs[0].source.labels = {ball(1, "cyst", {0.43, 0.65, 0.55}, 0.04),
                                      ball(2, "nodule", {0.2, 0.2, 0.3}, 0.03)};
  scenario.task.emplace();
  scenario.task->text =
      "teaches = \"x\"\ngoal = {kind = \"touch\", places = [{place = [0.5, 1, 0.5], depth = 0}]}\n"
      "limits = {structures_hurt = 0}\n";
  record(scenario, folder / "cut.resect", 260, [](std::int64_t) { return Sight::Unknown; });
  const Scored scored = score(readAttempt(folder / "cut.resect"));
  CHECK(scored.attempt.hurt == std::vector<std::string>{"cyst"});
  CHECK(*valueOf(scored.measures, "structures_hurt") == 1);
  const auto& told = scored.verdict.deductions;
  CHECK(std::ranges::any_of(told, [](const Deduction& d) {
    return d.fact == "Other structures hurt: 1, wanted at most 0. The cyst was hurt.";
  }));

  // Where there is no other structure, nothing is said of any.
  record(coarse("tasks", "touch-and-hold"), folder / "none.resect", 60,
         [](std::int64_t) { return Sight::Unknown; });
  CHECK(!valueOf(score(readAttempt(folder / "none.resect")).measures, "structures_hurt"));
}
