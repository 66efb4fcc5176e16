// Recordings saved under a name, limited in size, and the window's own ones.
#include <doctest/doctest.h>

#include <chrono>
#include <cstdlib>

#include "base/error.h"
#include "io/data_folder.h"
#include "io/operation_setup.h"
#include "io/plain_mesh.h"
#include "io/scenario/scenario_file.h"
#include "record/replay.h"
#include "record/session_recordings.h"
#include "support/sentence.h"
#include "support/temporary_folder.h"

using namespace resect;
namespace fs = std::filesystem;

namespace {

Scenario coarsePress(const std::string& setting = "table") {
  Scenario press = readScenario(findDataFile("press", "scenarios", ".toml"));
  press.setting = setting;
  setSpacing(press, *press.organs[0].source.spacing, 0.015);
  return press;
}

// An operation of a few particles that is recorded while it runs.
struct Recorded {
  explicit Recorded(const fs::path& path, const std::string& setting = "table")
      : scenario(coarsePress(setting)), recorder(path, scenario, simulation) {}

  void run(int frames) {
    for (int i = 0; i < frames; ++i) {
      const FrameInput input = frameInput(scenario, simulation.frame());
      simulation.step(input, report);
      recorder.record(input, report, simulation);
    }
  }
  // As the window does.
  void save(const fs::path& path) { recorder.saveAs(path, {0, simulation.frame()}); }

  Scenario scenario;
  Simulation simulation = makeSimulation(scenario, readPlainMesh);
  StepReport report;
  Recorder recorder;
};

std::vector<std::string> namesIn(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder))
    names.push_back(entry.path().filename().string());
  std::ranges::sort(names);
  return names;
}

std::string settingIn(const fs::path& path) { return Replay(path).setup().scenario.setting; }

std::int64_t framesOf(const fs::path& path) {
  const Verification proof = verify(path);
  CHECK(!proof.first);
  CHECK(proof.complete);
  return proof.frames;
}

}  // namespace

TEST_CASE("a recording keeps what stood round the organ") {
  const test::TemporaryFolder folder;
  for (const char* setting : {"table", "field"}) {
    Scenario scenario = coarsePress();
    scenario.setting = setting;
    Simulation simulation = makeSimulation(scenario, readPlainMesh);
    const fs::path path = folder / (std::string(setting) + ".resect");
    Recorder(path, scenario, simulation);
    CHECK(settingIn(path) == setting);
  }
}

TEST_CASE("a recording is played with what stopped tissue when it was made") {
  const test::TemporaryFolder folder;
  for (const char* setting : {"table", "field"}) {
    CAPTURE(setting);
    Recorded operation(folder / (std::string(setting) + ".resect"), setting);
    operation.run(40);
    const Surroundings& there = operation.simulation.surroundings();
    CHECK(there.bodies.size() == 1);  // the tray, or the abdominal wall
    operation.save(folder / "saved.resect");
    CHECK(framesOf(folder / "saved.resect") == 40);
    RecordedSetup setup = Replay(folder / "saved.resect").setup();
    REQUIRE(setup.surroundings.has_value());
    const auto same = [&](const Surroundings& other) {
      bool equal = other.bodies.size() == there.bodies.size() &&
                   other.edge.has_value() == there.edge.has_value();
      for (std::size_t i = 0; equal && i < there.bodies.size(); ++i)
        equal = other.bodies[i].name == there.bodies[i].name &&
                other.bodies[i].shape.points == there.bodies[i].shape.points &&
                other.bodies[i].pose.position == there.bodies[i].pose.position;
      return equal;
    };
    CHECK(same(*setup.surroundings));
    CHECK(same(simulationOf(setup).surroundings()));
    // One of a version that did not keep it: the tray, and a table without an end.
    setup.surroundings.reset();
    const RecordedSetup older = setupFromBytes(toBytes(setup));
    CHECK_FALSE(older.surroundings.has_value());
    const Simulation played = simulationOf(older);
    REQUIRE(played.surroundings().bodies.size() == 1);
    CHECK(played.surroundings().bodies[0].name == "tool box");
    CHECK_FALSE(played.surroundings().edge.has_value());
  }
}

TEST_CASE("an operation saved over a recording with a log replaces both") {
  const test::TemporaryFolder folder;
  // As a program that was killed leaves it: what it recorded is in the log.
  Recorded killed(folder / "killed.resect");
  killed.run(30);
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  fs::copy_file(folder / "killed.resect", folder / "kept.resect");
  fs::copy_file(folder / "killed.resect-wal", folder / "kept.resect-wal");
  CHECK(verify(folder / "kept.resect").frames == 30);

  Recorded operation(folder / "own.resect");
  operation.run(12);
  operation.save(folder / "kept.resect");
  CHECK(framesOf(folder / "kept.resect") == 12);
  CHECK(!fs::exists(folder / "kept.resect-wal"));
  operation.run(5);
  operation.save(folder / "kept.resect");
  CHECK(framesOf(folder / "kept.resect") == 17);
}

TEST_CASE("an operation is not saved over its own recording, nor where nothing can be written") {
  const test::TemporaryFolder folder;
  Recorded operation(folder / "own.resect");
  operation.run(5);
  fs::create_symlink(folder / "own.resect", folder / "link.resect");
  for (const char* name : {"own.resect", "own.resect-wal", "link.resect"})
    CHECK(test::refuses([&] { operation.save(folder / name); }, "is being recorded"));
  const auto kept = folder.write("file", "mine");
  CHECK(test::isOneSentence(
      test::sentenceOf([&] { operation.save(folder / "file" / "saved.resect"); })));
  CHECK(test::refuses([&] { operation.save("/dev/null"); }, "is no file"));
  CHECK(test::bytesOf(kept) == "mine");
  operation.recorder.finish();
  CHECK(framesOf(folder / "own.resect") == 5);
  CHECK(namesIn(folder.path()) == std::vector<std::string>{"file", "link.resect", "own.resect"});
}

TEST_CASE("a recording ends before it is too large to be read, and is saved all the same") {
  const test::TemporaryFolder folder;
  Recorded operation(folder / "own.resect");
  operation.recorder.setMostBytes(1 << 20);
  for (int i = 0; i < 600 && operation.recorder.failure().empty(); ++i) {
    operation.run(60);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  CHECK(operation.recorder.failure().find("has 1 MB, the most") != std::string::npos);
  operation.run(5);  // the operation goes on
  CHECK(test::refuses([&] { operation.save(folder / "saved.resect"); }, "all until then is saved"));
  CHECK(framesOf(folder / "saved.resect") > 60);
}

TEST_CASE("a recording is made in a folder that a link leads to, or that is not there yet") {
  const test::TemporaryFolder folder;
  fs::create_directory(folder / "real");
  fs::create_directory_symlink(folder / "real", folder / "link");
  for (const fs::path& path : {folder / "link" / "a.resect", folder / "new" / "b" / "a.resect"}) {
    Recorded operation(path);
    operation.run(3);
    operation.recorder.finish();
    CHECK(framesOf(path) == 3);
    CHECK(namesIn(path.parent_path()) == std::vector<std::string>{"a.resect"});
  }
}

TEST_CASE("the window's recordings stay in their folder, and the last written are kept") {
  const test::TemporaryFolder folder;
  ::setenv("XDG_STATE_HOME", folder.path().c_str(), 1);
  Scenario scenario = readScenario(findDataFile("press", "scenarios", ".toml"));
  setSpacing(scenario, *scenario.organs[0].source.spacing, 0.015);
  scenario.name = "x/../../../../../outside";  // a name in a recording of somebody else
  const Simulation simulation = makeSimulation(scenario, readPlainMesh);
  const fs::path own = recordingsFolder();
  // Of a clock that was ahead, and the opened one, written longest ago.
  fs::create_directories(own);
  const auto now = fs::file_time_type::clock::now();
  for (int i = 0; i < 30; ++i) {
    const fs::path path = folder.write("one", "");
    fs::rename(path, own / fmt::format("2099-01-01_{:02}.resect", i));
    fs::last_write_time(own / fmt::format("2099-01-01_{:02}.resect", i),
                        now + std::chrono::hours(i - 5));
  }
  const auto recorder = recordSession(scenario, simulation);
  CHECK(recorder->path().parent_path() == own);
  CHECK(fs::exists(recorder->path()));
  const auto kept = sessionRecordings();
  CHECK(kept.size() == std::size_t(kKeptRecordings));
  CHECK(kept[0].path.filename() == "2099-01-01_29.resect");
  CHECK(!fs::exists(own / "2099-01-01_10.resect"));
  CHECK(fs::exists(own / "2099-01-01_11.resect"));
  CHECK(namesIn(folder.path()) == std::vector<std::string>{"resect"});
  ::unsetenv("XDG_STATE_HOME");
}
