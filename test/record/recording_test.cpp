// Recordings: what is recorded comes back, is proved, and any change is found.
#include <doctest/doctest.h>
#include <sqlite3.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <thread>

#include "base/error.h"
#include "base/random.h"
#include "io/data_folder.h"
#include "io/operation_setup.h"
#include "io/plain_mesh.h"
#include "io/scenario/scenario_file.h"
#include "record/file/frame_bytes.h"
#include "record/ledger_rows.h"
#include "record/replay.h"
#include "support/sentence.h"
#include "support/temporary_folder.h"

using namespace resect;

namespace {

Scenario shipped(const std::string& name, double spacing) {
  Scenario scenario = readScenario(findDataFile(name, "scenarios", ".toml"));
  setSpacing(scenario, *scenario.organs[0].source.spacing, spacing);
  return scenario;
}

// Runs `frames` frames of the scenario and records them.
std::uint64_t recordRun(Scenario scenario, const std::filesystem::path& path, int frames) {
  Simulation simulation = makeSimulation(scenario, readPlainMesh);
  Recorder recorder(path, scenario, simulation);
  StepReport report;
  for (int i = 0; i < frames; ++i) {
    const FrameInput input = frameInput(scenario, i);
    simulation.step(input, report);
    recorder.record(input, report, simulation);
  }
  recorder.stood({0, simulation.frame()}, simulation);
  recorder.finish();
  CHECK(recorder.failure() == "");
  return simulation.stateHash();
}

// What a statement's rows hold, as another program reads them: an empty one where it has no rows.
std::vector<std::string> read(const std::filesystem::path& path, const std::string& sql) {
  std::vector<std::string> values;
  sqlite3* db = nullptr;
  REQUIRE(::sqlite3_open(path.c_str(), &db) == SQLITE_OK);
  sqlite3_stmt* statement = nullptr;
  if (::sqlite3_prepare_v2(db, sql.c_str(), -1, &statement, nullptr) == SQLITE_OK)
    while (::sqlite3_step(statement) == SQLITE_ROW)
      for (int c = 0; c < ::sqlite3_column_count(statement); ++c) {
        const char kind = char('0' + ::sqlite3_column_type(statement, c));
        const auto* bytes = static_cast<const char*>(::sqlite3_column_blob(statement, c));
        values.push_back(kind +
                         std::string(bytes, std::size_t(::sqlite3_column_bytes(statement, c))));
      }
  ::sqlite3_finalize(statement);
  ::sqlite3_close(db);
  return values;
}

// Changes a file as another program would.
void write(const std::filesystem::path& path, const std::string& sql, const Bytes& blob = {}) {
  sqlite3* db = nullptr;
  REQUIRE(::sqlite3_open(path.c_str(), &db) == SQLITE_OK);
  sqlite3_stmt* statement = nullptr;
  REQUIRE(::sqlite3_prepare_v2(db, sql.c_str(), -1, &statement, nullptr) == SQLITE_OK);
  if (!blob.empty())
    ::sqlite3_bind_blob64(statement, 1, blob.data(), blob.size(), SQLITE_TRANSIENT);
  CHECK(::sqlite3_step(statement) == SQLITE_DONE);
  ::sqlite3_finalize(statement);
  ::sqlite3_close(db);
}

void run(const std::filesystem::path& path, const std::string& sql) {
  sqlite3* db = nullptr;
  REQUIRE(::sqlite3_open(path.c_str(), &db) == SQLITE_OK);
  CHECK(::sqlite3_exec(db, sql.c_str(), nullptr, nullptr, nullptr) == SQLITE_OK);
  ::sqlite3_close(db);
}

}  // namespace

TEST_CASE("a setup comes back from its bytes and steps to the same bits") {
  for (const char* name : {"press", "incise", "liver-and-gallbladder", "resect-segment"}) {
    CAPTURE(name);
    Scenario scenario = readScenario(findDataFile(name, "scenarios", ".toml"));
    if (scenario.organs[0].source.spacing)
      setSpacing(scenario, *scenario.organs[0].source.spacing, 0.009);
    Simulation first = makeSimulation(scenario, readPlainMesh);
    const RecordedSetup setup = setupFromBytes(toBytes(setupOf(scenario, first)));
    Simulation second = simulationOf(setup);
    for (int i = 0; i < 30; ++i) {
      first.step(frameInput(scenario, i));
      second.step(frameInput(setup.scenario, i));
    }
    CHECK(first.stateHash() == second.stateHash());
  }
}

TEST_CASE("inputs of frames come back from their bytes") {
  FrameInput before, input;
  input.duration = 1.0 / 77;
  input.iso = 43.5f;
  input.tools.resize(3);
  input.tools[1] = {{{0.1, -0.0, 1e-300}, Eigen::Quaterniond(0.5, 0.5, -0.5, 0.5)}, false, 0.25, 1};
  Incision incision;
  incision.blade = sweepBlade(std::vector<Vec3>{{0, 0, 0}, {0, 0, 0.01}}, {}, {{0.01, 0, 0}, {}});
  input.edits = {{0, 1, RemoveCell{17}},
                 {1, -1, SeverBond{4, 25}},
                 {0, 2, incision},
                 {0, 0, Grip{9, {}}},
                 {0, 0, Release{}},
                 {0, -1, SetLabel{5, 200}},
                 {0, -1, PlaceClip{4, 0.25}},
                 {0, 1, Heat{Vec3(1, 2, 3), 0.004, 30}},
                 {0, -1, ClampInflow{false}},
                 {0, 0, Suction{Vec3(3, 2, 1), 0.01, 25e-6}},
                 {0, 2, RemoveCell{18, 0.0005}},
                 {0, 1, Press{Vec3(4, 5, 6), 0.02, 1500, 4e-6}},
                 {0, -1, DivideVessel{3, 0.75}},
                 {0, -1, TearBond{4, 3, 0.001}},
                 {0, 1, Carve{{Vec3(1, 2, 3), Vec3(3, 2, 1), 0.004}, 0.0005}}};
  const auto again = [&](const FrameInput& last) {
    return frameToBytes(frameFromBytes(frameToBytes(input, last), last), last);
  };
  CHECK(again(before) == frameToBytes(input, before));
  for (const std::optional<bool> breathes : {std::optional(true), std::optional(false), {}}) {
    input.breathes = breathes;
    CHECK(again(before) == frameToBytes(input, before));
    CHECK(frameFromBytes(frameToBytes(input, before), before).breathes == breathes);
  }
  before = input;
  before.tools[2].pedal = 0.5;
  CHECK(again(before) == frameToBytes(input, before));
  CHECK(frameToBytes(input, before).size() < frameToBytes(input, {}).size());

  const Bytes bytes = frameToBytes(input, {});
  for (std::size_t cut = 0; cut < bytes.size(); ++cut)
    CHECK_THROWS_AS(frameFromBytes(std::span(bytes).first(cut), {}), Error);
}

TEST_CASE("a recording is replayed, moved to any frame and proved") {
  const test::TemporaryFolder folder;
  for (const char* name : {"press", "resect-segment"}) {
    CAPTURE(name);
    const auto path = folder / (std::string(name) + ".resect");
    const std::uint64_t hash = recordRun(shipped(name, 0.009), path, 100);
    const Verification proof = verify(path);
    CHECK_MESSAGE(!proof.first, (proof.first ? proof.first->what : ""));
    CHECK(proof.frames == 100);
    CHECK(proof.complete);
    Replay replay(path);
    replay.goTo(0, 100);
    CHECK(replay.simulation().stateHash() == hash);
    replay.goTo(0, 40);
    const std::uint64_t there = replay.simulation().stateHash();
    replay.goTo(0, 73);
    replay.goTo(0, 40);
    CHECK(replay.simulation().stateHash() == there);
    CHECK_THROWS_AS(replay.goTo(0, 101), Error);
    CHECK_THROWS_AS(replay.goTo(3, 1), Error);
  }
}

TEST_CASE("a breathing patient is recorded, held breath and all, and proved") {
  const test::TemporaryFolder folder;
  const std::filesystem::path path = folder / "breathing.resect";
  Scenario scenario = shipped("incise", 0.012);
  setBreathing(scenario, 0.01);
  {
    Simulation simulation = makeSimulation(scenario, readPlainMesh);
    Recorder recorder(path, scenario, simulation);
    StepReport report;
    for (int i = 0; i < 720; ++i) {
      FrameInput input = frameInput(scenario, i % 200);
      if (i == 100) input.breathes = false;
      if (i == 400) input.breathes = true;
      simulation.step(input, report);
      if (i == 399) CHECK(simulation.breath().phase == 0);
      recorder.record(input, report, simulation);
    }
    CHECK(simulation.breath().phase > 0.01);
    recorder.stood({0, simulation.frame()}, simulation);
    recorder.finish();
  }
  const Verification proof = verify(path);
  CHECK(!proof.first);
  CHECK(proof.frames == 720);
  CHECK(proof.keyStates == 2);
  Replay replay(path);
  replay.goTo(0, 450);
  CHECK(replay.setup().scenario.breathing.depth == 0.01);
  CHECK(replay.simulation().breath().on);
  replay.goTo(0, 250);
  CHECK(!replay.simulation().breath().on);
}

TEST_CASE("branches begin where a stroke was taken back, and are proved too") {
  const test::TemporaryFolder folder;
  const auto path = folder / "branches.resect";
  Scenario scenario = shipped("press", 0.012);
  Simulation simulation = makeSimulation(scenario, readPlainMesh);
  {
    Recorder recorder(path, scenario, simulation);
    Bytes kept;
    for (int i = 0; i < 60; ++i) {
      if (i == 20) kept = simulation.save();
      const FrameInput input = frameInput(scenario, i);
      recorder.record(input, simulation.step(input), simulation);
    }
    simulation.restore(kept);
    recorder.begin({1, 0, 20, "second"}, simulation);
    EventMemory memory;
    for (int i = 0; i < 15; ++i) {
      const FrameInput input = frameInput(scenario, 20 + 2 * i);
      const StepReport report = simulation.step(input);
      recorder.record({1, simulation.frame()}, input, report, eventsOf(report, simulation, memory),
                      simulation);
    }
  }
  const Verification proof = verify(path);
  CHECK_MESSAGE(!proof.first, (proof.first ? proof.first->what : ""));
  CHECK(proof.branches == 2);
  CHECK(proof.frames == 75);
  Replay replay(path);
  replay.goTo(1, 35);
  CHECK(replay.simulation().stateHash() == simulation.stateHash());
}

TEST_CASE("the ledger is recorded once a second and at the end, and is proved") {
  const test::TemporaryFolder folder;
  const auto path = folder / "segment.resect";
  Scenario scenario = shipped("resect-segment", 0.007);
  recordRun(scenario, path, 390);  // 6.5 s
  const Verification proof = verify(path);
  CHECK_MESSAGE(!proof.first, (proof.first ? proof.first->what : ""));
  std::vector<RecordedLedger> ledgers;
  {
    Replay replay(path);
    ledgers = replay.file().ledgers(0);
    REQUIRE(ledgers.size() > 3);
    CHECK(ledgers[0].frame == 0);
    for (std::size_t i = 0; i < ledgers.size(); ++i) {
      if (i > 0 && i + 1 < ledgers.size()) CHECK(ledgers[i].time >= ledgers[i - 1].time + 1 - 1e-9);
      double before = 0, after = 0;
      for (const RecordedLedger::Amount& amount : ledgers[i].amounts)
        (amount.part == "before" ? before : after) += amount.ml;
      CHECK(std::abs(before / after - 1) < 1e-12);
    }
    replay.goTo(0, 390);
    const RecordedLedger end =
        rowsOf(LedgerBooks(scenario, replay.simulation()).ledgerOf(replay.simulation()), 0,
               replay.simulation());
    CHECK(end.amounts == ledgers.back().amounts);
    CHECK(end.wounds == ledgers.back().wounds);
    CHECK(std::ranges::find(end.amounts, "removed", &RecordedLedger::Amount::part) !=
          end.amounts.end());
  }
  const auto changed = folder / "changed.resect";
  for (const char* sql :
       {"UPDATE ledger SET particles = particles + 1 WHERE part = 'removed'",
        "UPDATE ledger SET g = g * 1.0000001 WHERE frame > 100",
        "UPDATE wounds SET amount = amount * 1.0000001", "DELETE FROM wounds WHERE frame > 200",
        "DELETE FROM ledger; DELETE FROM wounds",
        "INSERT INTO ledger VALUES (0, 389, 6.4, 0, 0, 'body', 0, 1, 1, 1)"}) {
    CAPTURE(sql);
    std::filesystem::copy_file(path, changed, std::filesystem::copy_options::overwrite_existing);
    run(changed, sql);
    const Verification wrong = verify(changed);
    REQUIRE(wrong.first);
    CHECK(wrong.first->what.find("ledger") != std::string::npos);
  }
}

TEST_CASE("a recording of another schema is refused with what to do") {
  const test::TemporaryFolder folder;
  const auto path = folder / "press.resect";
  recordRun(shipped("press", 0.015), path, 3);
  run(path, "PRAGMA user_version = 1");
  CHECK(test::refuses([&] { verify(path); }, "use the Resect that recorded it"));
  run(path, fmt::format("PRAGMA user_version = {}", kRecordingSchema + 1));
  CHECK(test::refuses([&] { verify(path); }, "use a newer Resect"));
}

TEST_CASE("a changed bit is found, wherever it is") {
  const test::TemporaryFolder folder;
  const auto path = folder / "press.resect";
  recordRun(shipped("press", 0.015), path, 40);
  Random random(1);
  for (int i = 0; i < 40; ++i) {
    const auto changed = folder / "changed.resect";
    std::filesystem::copy_file(path, changed, std::filesystem::copy_options::overwrite_existing);
    const char* places[][2] = {{"frames", "input"},
                               {"frames", "hashes"},
                               {"key_states", "state"},
                               {"scenario", "setup"},
                               {"organ", "cells"}};
    const auto& place = places[i % 5];
    const std::string of = std::string(" FROM ") + place[0];
    std::string row;
    Bytes bytes;
    {
      const std::vector<std::string> values = read(changed, std::string("SELECT ") + place[1] + of);
      const int chosen = random.below(int(values.size()));
      row = std::to_string(chosen);
      for (const char c : values[std::size_t(chosen)].substr(1)) bytes.push_back(std::byte(c));
    }
    bytes[std::size_t(random.below(int(bytes.size())))] ^= std::byte(1 << random.below(8));
    const std::string key = std::string(place[0]) == "frames"
                                ? "frame = (SELECT frame FROM frames LIMIT 1 OFFSET " + row + ")"
                                : "rowid = (SELECT rowid" + of + " LIMIT 1 OFFSET " + row + ")";
    write(changed, std::string("UPDATE ") + place[0] + " SET " + place[1] + " = ? WHERE " + key,
          bytes);
    CAPTURE(place[0]);
    CAPTURE(place[1]);
    std::string found;
    try {
      const Verification proof = verify(changed);
      if (proof.first) found = proof.first->what;
    } catch (const Error& e) {
      found = e.what();
    }
    CHECK(found != "");
  }
}

// Single bits anywhere in the file, every second one among the first bytes of a page, where SQLite
// keeps its own numbers. RESECT_FLIPS: how many; without it 40.
TEST_CASE("a flipped bit anywhere in the file is found, or changes nothing that can be read") {
  const test::TemporaryFolder folder;
  const auto path = folder / "press.resect", changed = folder / "changed.resect";
  recordRun(shipped("press", 0.015), path, 30);
  const auto contentOf = [&](const std::filesystem::path& file) {
    std::vector<std::vector<std::string>> content;
    for (const char* table : {"meta", "scenario", "organ", "branch", "frames", "events", "samples"})
      content.push_back(read(file, std::string("SELECT * FROM ") + table));
    content.push_back(read(file, "SELECT branch, frame, state_hash, size FROM key_states"));
    return content;
  };
  const auto statesOf = [&](const std::filesystem::path& file) {
    RecordingFile recording = RecordingFile::open(file);
    std::vector<Bytes> states;
    for (const std::int64_t frame : recording.keyFrames(0))
      states.push_back(recording.keyState(0, frame)->state);
    return states;
  };
  const auto content = contentOf(path);
  const auto states = statesOf(path);
  const std::string bytes = test::bytesOf(path);
  const char* asked = std::getenv("RESECT_FLIPS");
  Random random(2);
  int refused = 0, told = 0, unread = 0;
  for (int i = 0, flips = asked ? std::atoi(asked) : 40; i < flips; ++i) {
    std::string damaged = bytes;
    std::size_t at = std::size_t(random.below(int(bytes.size())));
    if (i % 2 == 1) at = at / 4096 * 4096 + at % 64;
    damaged[at] = char(damaged[at] ^ (1 << random.below(8)));
    folder.write("changed.resect", damaged);
    CAPTURE(i);
    CAPTURE(at);
    try {
      if (verify(changed).first) {
        ++told;
      } else {
        ++unread;
        CHECK(statesOf(changed) == states);
        CHECK(contentOf(changed) == content);
      }
    } catch (const Error& e) {
      ++refused;
      CHECK(test::isOneSentence(e.what()));
    }
  }
  MESSAGE(refused << " refused, " << told << " told by verify, " << unread << " change nothing");
  CHECK(refused + told > 0);
}

TEST_CASE("a flipped bit in the log of a recording that was not ended shortens it, or is found") {
  const test::TemporaryFolder folder;
  const auto path = folder / "going-on.resect";
  Scenario scenario = shipped("press", 0.015);
  Simulation simulation = makeSimulation(scenario, readPlainMesh);
  Recorder recorder(path, scenario, simulation);
  for (int i = 0; i < 90; ++i) {
    const FrameInput input = frameInput(scenario, i);
    recorder.record(input, simulation.step(input), simulation);
    if (i % 30 == 29) std::this_thread::sleep_for(std::chrono::milliseconds(300));  // it commits
  }
  const std::string file = test::bytesOf(path), log = test::bytesOf(path.string() + "-wal");
  REQUIRE(log.size() > 4096);
  const auto copy = folder.write("copy.resect", file);
  folder.write("copy.resect-wal", log);
  CHECK(verify(copy).frames == 90);
  Random random(3);
  int shorter = 0, found = 0;
  for (int i = 0; i < 30; ++i) {
    std::string damaged = log;
    char& byte = damaged[std::size_t(random.below(int(log.size())))];
    byte = char(byte ^ (1 << random.below(8)));
    folder.write("copy.resect-wal", damaged);
    try {
      const Verification proof = verify(copy);
      CHECK(!proof.complete);
      CHECK(proof.frames <= 90);
      proof.first ? ++found : ++shorter;
    } catch (const Error& e) {
      ++found;
      CHECK(test::isOneSentence(e.what()));
    }
  }
  MESSAGE(shorter << " shortened or unchanged, " << found << " found");
  recorder.finish();
}

TEST_CASE("what is no recording is refused in a sentence") {
  const test::TemporaryFolder folder;
  const auto path =
      folder.write("text.resect", "some text, long enough to be looked at as a database");
  CHECK(test::isOneSentence(test::sentenceOf([&] { verify(path); })));
  CHECK(test::isOneSentence(test::sentenceOf([&] { verify(folder / "none.resect"); })));
  const auto other = folder / "other.resect";
  write(other, "CREATE TABLE t (x)");
  CHECK(test::refuses([&] { verify(other); }, "is no recording"));
}

TEST_CASE("a recording replaces nothing, and reading one changes nothing") {
  const test::TemporaryFolder folder;
  Scenario scenario = shipped("press", 0.015);
  const Simulation simulation = makeSimulation(scenario, readPlainMesh);
  for (const char* name : {"a.resect", "b.resect-wal", "c.resect-journal"}) {
    const auto kept = folder.write(name, "mine");
    const std::string target = std::string(1, name[0]) + ".resect";
    CHECK(test::refuses([&] { Recorder(folder / target, scenario, simulation); },
                        "is there already"));
    CHECK(test::bytesOf(kept) == "mine");
  }
  const auto path = folder / "d.resect";
  recordRun(scenario, path, 5);
  // A journal beside it that would have SQLite delete another file.
  const auto journal = folder.write("d.resect-journal", "not SQLite's");
  const std::string before = test::bytesOf(path);
  CHECK(!verify(path).first);
  CHECK(test::bytesOf(path) == before);
  CHECK(test::bytesOf(journal) == "not SQLite's");
  write(path, "CREATE VIEW v AS SELECT 1");
  CHECK(test::refuses([&] { verify(path); }, "its tables are not those of a recording"));
  std::filesystem::create_symlink(path, folder / "link.resect");
  CHECK(test::refuses([&] { verify(folder / "link.resect"); }, "is no ordinary file"));
}
