// An operation that was recorded goes on, from any of its branches, as if it had never ended.
#include "record/recorded_history.h"

#include <doctest/doctest.h>

#include "base/error.h"
#include "io/data_folder.h"
#include "io/operation_setup.h"
#include "io/plain_mesh.h"
#include "io/scenario/scenario_file.h"
#include "record/recorder.h"
#include "record/replay.h"
#include "support/temporary_folder.h"

using namespace resect;

namespace {

// An operation with a recorder, as the window has them.
struct Kept {
  const Scenario& scenario;
  Simulation& simulation;
  OperationHistory& history;
  Recorder& recorder;
  StepReport report;

  void step(int scenarioFrame) {
    const FrameInput input = frameInput(scenario, scenarioFrame);
    if (const auto branch = history.beforeStep(input, simulation))
      recorder.begin(*branch, simulation);
    simulation.step(input, report);
    const auto events = history.afterStep(input, report, simulation);
    recorder.record(history.now(), input, report, events, simulation);
  }
};

}  // namespace

TEST_CASE("a recorded operation goes on where it was, and what is added is proved with the rest") {
  const test::TemporaryFolder folder;
  for (const char* name : {"resect-segment-elastic", "cut-950"}) {
    CAPTURE(name);
    Scenario scenario = readScenario(findDataFile(name, "scenarios", ".toml"));
    setSpacing(scenario, scenario.organs[0].source.spacing.value_or(0.01), 0.012);
    const auto first = folder / (std::string(name) + ".resect"),
               second = folder / (std::string(name) + "-2.resect"),
               saved = folder / (std::string(name) + "-saved.resect"),
               live = folder / (std::string(name) + "-live.resect");
    Simulation simulation = makeSimulation(scenario, readPlainMesh);
    OperationHistory history(simulation, scenario.frameRate);
    {
      Recorder recorder(first, scenario, simulation);
      Kept kept{scenario, simulation, history, recorder, {}};
      for (int i = 0; i < 160; ++i) kept.step(i);
      history.goTo({0, 70}, simulation);
      for (int i = 0; i < 60; ++i) kept.step(70 + 2 * i);
      history.rename(1, "another way");
      recorder.rename(history.courses()[1].branch);
    }
    RecordingFile file = RecordingFile::open(first);
    RecordedOperation operation = operationOf(file, file.setup());
    CHECK(operation.history.now() == history.now());
    CHECK(operation.simulation->stateHash() == simulation.stateHash());
    CHECK(operation.history.undoable() == history.undoable());
    CHECK(operation.history.peaks() == history.peaks());
    REQUIRE(operation.history.courses().size() == 2);
    CHECK(operation.history.courses()[1].branch.name == "another way");
    if (name == std::string("cut-950")) CHECK(operation.history.courses()[0].bared > 0);
    for (int b = 0; b < 2; ++b) {
      const auto &was = history.courses()[std::size_t(b)],
                 &is = operation.history.courses()[std::size_t(b)];
      CHECK(is.end() == was.end());
      CHECK(is.peaks == was.peaks);
      REQUIRE(is.strokes.strokes().size() == was.strokes.strokes().size());
      for (std::size_t i = 0; i < is.strokes.strokes().size(); ++i) {
        const Stroke &x = is.strokes.strokes()[i], &y = was.strokes.strokes()[i];
        CHECK((x.from == y.from && x.to == y.to && x.tool == y.tool && x.removed == y.removed &&
               x.severed == y.severed && x.torn == y.torn));
      }
    }
    {
      Recorder recorder(second, file, scenario, *operation.simulation);
      Kept kept{scenario, *operation.simulation, operation.history, recorder, {}};
      for (int i = 0; i < 30; ++i) kept.step(190 + i);
      operation.history.goTo({0, 160}, *operation.simulation);
      for (int i = 0; i < 20; ++i) kept.step(160 + i);
      recorder.saveAs(saved, {0, 175});
      recorder.saveAs(live, {0, kEndOfBranch});
    }
    for (const auto& path : {second, saved}) {
      const Verification proof = verify(path);
      CHECK_MESSAGE(!proof.first, (proof.first ? proof.first->what : ""));
      CHECK(proof.frames == 160 + 60 + 30 + 20);
      CHECK(proof.branches == 2);
      CHECK(proof.complete);
    }
    // The same as without the pause between.
    Replay replay(saved);
    replay.goTo(0, 180);
    CHECK(replay.simulation().stateHash() == operation.simulation->stateHash());
    CHECK(RecordingFile::open(saved).moment() == Moment{0, 175});
    CHECK(RecordingFile::open(live).moment() == Moment{0, 180});
    CHECK(RecordingFile::open(second).moment() == Moment{0, 180});
    CHECK_THROWS_AS(operationOf(file, file.setup(), 2), Error);
  }
}

TEST_CASE("a recording of another version, whose states mean nothing here, is played and proved") {
  const test::TemporaryFolder folder;
  Scenario scenario = readScenario(findDataFile("press", "scenarios", ".toml"));
  setSpacing(scenario, scenario.organs[0].source.spacing.value_or(0.01), 0.015);
  Simulation simulation = makeSimulation(scenario, readPlainMesh);
  OperationHistory history(simulation, scenario.frameRate);
  const auto own = folder / "own.resect", other = folder / "other.resect";
  {
    Recorder recorder(own, scenario, simulation);
    Kept kept{scenario, simulation, history, recorder, {}};
    for (int i = 0; i < 90; ++i) kept.step(i);
    history.goTo({0, 70}, simulation);
    for (int i = 0; i < 20; ++i) kept.step(72 + i);
  }
  {
    RecordingFile file = RecordingFile::open(own);
    RecordingFile changed = RecordingFile::goOn(other, file);
    changed.setProgram("resect 0.0.1");
    for (const Moment at : {Moment{0, 0}, Moment{1, 70}})
      changed.add(KeyState{at.branch, at.frame, Bytes(100, std::byte(7)), 0});
    changed.finish();
  }
  const Verification proof = verify(other);
  CHECK_MESSAGE(!proof.first, (proof.first ? proof.first->what : ""));
  CHECK(proof.otherProgram);
  CHECK(proof.frames == 110);
  RecordingFile file = RecordingFile::open(other);
  const RecordedOperation operation = operationOf(file, file.setup());
  CHECK(operation.history.now() == Moment{1, 90});
  CHECK(operation.simulation->stateHash() == simulation.stateHash());
}
