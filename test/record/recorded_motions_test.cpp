// The motions of a recording become keys that play the same motions.
#include "record/recorded_motions.h"

#include <doctest/doctest.h>

#include <cmath>

#include "io/data_folder.h"
#include "io/operation_setup.h"
#include "io/plain_mesh.h"
#include "io/scenario/scenario_file.h"
#include "record/recorder.h"
#include "support/temporary_folder.h"

using namespace resect;

namespace {

constexpr MotionTolerance kTolerance;

void checkNear(const ToolInput& a, const ToolInput& b) {
  CHECK((a.pose.position - b.pose.position).norm() <= 1.001 * kTolerance.distance);
  CHECK(angleBetween(a.pose.rotation, b.pose.rotation) <= 1.001 * kTolerance.angle);
  CHECK(std::abs(a.squeeze - b.squeeze) <= 1.001 * kTolerance.share);
  CHECK(std::abs(a.pedal - b.pedal) <= 1.001 * kTolerance.share);
}

}  // namespace

TEST_CASE("motions of a recording: keys that are few and play the same") {
  const test::TemporaryFolder folder;
  Scenario scenario = readScenario(findDataFile("clip-and-divide", "tasks", ".toml"));
  setSpacing(scenario, *scenario.organs[0].source.spacing, 0.012);
  const int frames = int(frameCount(scenario));
  {
    Simulation simulation = makeSimulation(scenario, readPlainMesh);
    Recorder recorder(folder / "run.resect", scenario, simulation);
    StepReport report;
    for (int i = 0; i < frames; ++i) {
      const FrameInput input = frameInput(scenario, i);
      simulation.step(input, report);
      recorder.record(input, report, simulation);
    }
    recorder.finish();
  }
  RecordingFile file = RecordingFile::open(folder / "run.resect");
  const std::vector<std::vector<ToolKey>> motions = recordedMotions(file, file.moment());
  REQUIRE(motions.size() == scenario.tools.size());
  Scenario again = scenario;
  for (std::size_t t = 0; t < motions.size(); ++t) {
    CHECK(motions[t].empty() == scenario.tools[t].keys.empty());
    CHECK(motions[t].size() <= 3 * scenario.tools[t].keys.size());
    again.tools[t].keys = motions[t];
  }
  for (int i = 0; i < frames; ++i)
    for (std::size_t t = 0; t < motions.size(); ++t) {
      const ToolInput was = frameInput(scenario, i).tools[t], now = frameInput(again, i).tools[t];
      CHECK(was.inHand == now.inHand);
      if (was.inHand) checkNear(was, now);
    }
}

TEST_CASE("a way of many keys is thinned as far as the tolerance allows") {
  std::vector<ToolKey> keys;
  for (int i = 0; i <= 600; ++i) {
    const double time = i / 60.0;
    ToolKey key{time, {}, i < 300 ? 0.0 : 1.0, 0};
    key.pose.position = Vec3(0.02 * std::sin(time), 0.02 * std::cos(time), 0.001 * time);
    key.pose.rotation = rotationAbout(Vec3(0.6, 0.8, 0), 0.3 * std::sin(2 * time));
    keys.push_back(key);
  }
  const std::vector<ToolKey> fewer = thinned(keys, kTolerance);
  CHECK(fewer.size() < keys.size() / 8);
  CHECK(fewer.size() > 20);
  ScenarioTool tool;
  tool.keys = fewer;
  for (const ToolKey& key : keys)
    checkNear({key.pose, true, key.squeeze, key.pedal}, toolInputAt(tool, key.time));
  CHECK(thinned({keys[0]}, kTolerance).size() == 1);
  CHECK(thinned({}, kTolerance).empty());
  // Still in hand: two keys.
  std::vector<ToolKey> still(100, keys[0]);
  for (std::size_t i = 0; i < still.size(); ++i) still[i].time = double(i);
  CHECK(thinned(still, kTolerance).size() == 2);
}
