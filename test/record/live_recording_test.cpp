// What a live operation records is proved, however its person jumps about in it.
#include <doctest/doctest.h>

#include <chrono>
#include <filesystem>
#include <thread>

#include "base/random.h"
#include "io/data_folder.h"
#include "io/operation_setup.h"
#include "io/plain_mesh.h"
#include "io/scenario/scenario_file.h"
#include "operation/live/live_operation.h"
#include "record/replay.h"
#include "record/session_recordings.h"
#include "support/temporary_folder.h"

using namespace resect;

TEST_CASE("requests that come faster than they are answered leave a recording that is proved") {
  const test::TemporaryFolder folder;
  for (const int seed : {1, 2, 3}) {
    CAPTURE(seed);
    Scenario scenario = readScenario(findDataFile("resect-segment-elastic", "scenarios", ".toml"));
    setSpacing(scenario, scenario.organs[0].source.spacing.value_or(0.01), 0.013);
    const auto path = folder / (std::to_string(seed) + ".resect");
    auto simulation = std::make_unique<Simulation>(makeSimulation(scenario, readPlainMesh));
    std::vector<Pose> rests;
    for (const ScenarioTool& tool : scenario.tools) rests.push_back(tool.rest);
    auto recorder = std::make_shared<Recorder>(path, scenario, *simulation);
    LedgerWatch ledger(scenario, *simulation);
    {
      LiveOperation operation(std::move(simulation), rests, 600, watchOf(recorder), {},
                              std::move(ledger));
      Random random(seed);
      std::vector<SurfaceUpdate> updates;
      LiveState state;
      const auto pause = [&](int most) {
        std::this_thread::sleep_for(std::chrono::milliseconds(random.below(most)));
        operation.take(updates, state);
      };
      std::int64_t frame = 0;
      const auto motion = [&]() -> std::optional<FrameInput> {
        return frameInput(scenario, frame++ % 400);
      };
      operation.play(motion);
      operation.waitFor(150);
      pause(1);
      for (int i = 0; i < 150; ++i) {
        const int what = random.below(10);
        if (what < 4 && state.timeline) {
          for (int k = random.below(5); k >= 0; --k) {  // a drag along the bar
            const auto& courses = state.timeline->courses;
            const auto& course = courses[std::size_t(random.below(int(courses.size())))];
            const int length = int(course.end - course.branch.from);
            operation.show({course.branch.number, course.branch.from + random.below(length + 1)});
            pause(6);
          }
        } else if (what < 6) {
          operation.undo();
          if (random.below(2)) operation.undo();
        } else if (what < 7) {
          operation.redo();
        } else if (what < 8) {
          operation.setPlayback(random.uniform(1, 20), 0);
        } else {
          operation.waitForAnswer();
          operation.goOn();
          if (random.below(2)) operation.play(motion);
          if (random.below(3) == 0) operation.setIso(float(random.uniform(40, 60)));
        }
        pause(40);
      }
    }
    recorder->finish();
    CHECK(recorder->failure() == "");
    const Verification proof = verify(path);
    CHECK_MESSAGE(!proof.first, (proof.first ? proof.first->stage + ": " + proof.first->what : ""));
    CHECK(proof.complete);
    MESSAGE(proof.frames << " frames, " << proof.branches << " branches");
  }
}
