// An operation continues from a saved state with the same bits.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>

#include "base/error.h"
#include "base/parallel.h"
#include "base/progress.h"
#include "base/stop.h"
#include "io/data_folder.h"
#include "io/operation_setup.h"
#include "io/plain_mesh.h"
#include "io/scenario/scenario_file.h"
#include "operation/scenario.h"
#include "support/covered_bytes.h"
#include "support/elastic_block.h"
#include "support/resealed.h"
#include "support/test_tools.h"
#include "tissue/still_tissue.h"

using namespace resect;

namespace {

Scenario shipped(const std::string& name) {
  return readScenario(findDataFile(name, "scenarios", ".toml"));
}

void stepFrame(Simulation& simulation, const Scenario& scenario, std::int64_t frame) {
  simulation.step(frameInput(scenario, frame));
}

std::string differenceOf(const Simulation& a, const Simulation& b) {
  return firstDifference(a.fields(), b.fields()).value_or("");
}

// A block of elastic tissue with a scalpel half way through it and the table under it.
Simulation cutBlock() {
  Simulation simulation = test::elasticBlock({10, 5, 8}, 0.008, test::thinScalpel());
  FrameInput input;
  input.tools.resize(1);
  for (int i = 0; i < 20; ++i) {
    input.tools[0] = {{Vec3(0.04, 0.052 - 0.0015 * i, 0.005), Eigen::Quaterniond::Identity()}};
    simulation.step(input);
  }
  return simulation;
}

double millisecondsOf(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return 1e3 * std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

TEST_CASE("every shipped scenario, restored in another simulation, goes on with the same bits") {
  for (const std::string& name : shippedNames("scenarios", ".toml")) {
    CAPTURE(name);
    Scenario scenario = shipped(name);
    Simulation simulation = makeSimulation(scenario, readPlainMesh),
               other = makeSimulation(scenario, readPlainMesh);
    // Forty seconds of longer ones: what they do later, other scenarios do sooner.
    const std::int64_t frames = std::min<std::int64_t>(frameCount(scenario), 1200);
    // Three states are on their way at most: each is followed for ten frames.
    Bytes saved;
    std::int64_t savedAt = 0;
    int threads = 1;
    for (std::int64_t frame = 0; frame < frames; ++frame) {
      if (frame % 10 == 0) {
        // Every third state is followed, of short operations every second one.
        if (frame > 0 && frame / 10 % (frames < 200 ? 2 : 3) == 0) {
          // The other one takes the ten frames that lie behind at one, two or three threads.
          const ThreadLimit limit(threads);
          threads = threads % 3 + 1;
          other.restore(saved);
          for (std::int64_t again = savedAt; again < frame; ++again)
            stepFrame(other, scenario, again);
          const std::string difference = differenceOf(simulation, other);
          REQUIRE_MESSAGE(difference.empty(), "frame " << savedAt << ": " << difference);
          REQUIRE(simulation.stateHash() == other.stateHash());
        }
        saved = simulation.save();
        savedAt = frame;
      }
      stepFrame(simulation, scenario, frame);
    }
  }
}

TEST_CASE(
    "one scenario of each kind, restored in the middle of a fresh one, ends as it would have") {
  for (const char* name : {"cut-950", "press", "lift", "incise", "snip"}) {
    CAPTURE(name);
    Scenario scenario = shipped(name);
    Simulation simulation = makeSimulation(scenario, readPlainMesh);
    const std::int64_t frames = frameCount(scenario);
    Bytes saved;
    for (std::int64_t frame = 0; frame < frames; ++frame) {
      if (frame == 6 * frames / 10) saved = simulation.save();
      stepFrame(simulation, scenario, frame);
    }
    Simulation fresh = makeSimulation(scenario, readPlainMesh);
    fresh.restore(saved);
    CHECK(fresh.frame() == 6 * frames / 10);
    for (std::int64_t frame = fresh.frame(); frame < frames; ++frame)
      stepFrame(fresh, scenario, frame);
    CHECK(fresh.stateHash() == simulation.stateHash());
  }
}

TEST_CASE("a state saved as the iso level changes within a cut is restored whole") {
  Simulation simulation = test::elasticBlock({10, 5, 8}, 0.008, test::thinScalpel());
  Simulation other = test::elasticBlock({10, 5, 8}, 0.008, test::thinScalpel());
  FrameInput input;
  input.tools.resize(1);
  for (int i = 0; i < 20; ++i) {
    input.tools[0] = {{Vec3(0.04, 0.052 - 0.0015 * i, 0.005), Eigen::Quaterniond::Identity()}};
    input.iso = 45 + float(i % 3);
    simulation.step(input);
    const Bytes saved = simulation.save();
    other.step(input);
    CHECK(differenceOf(simulation, other) == "");
    other.restore(saved);
    CHECK(other.save() == saved);
  }
  CHECK(simulation.organ().severed.count() > 0);
}

TEST_CASE("a restore takes back a cut: the surface is that of before, bit for bit") {
  Simulation simulation = cutBlock();
  const Simulation whole = test::elasticBlock({10, 5, 8}, 0.008, test::ballTool(0.01));
  CHECK(simulation.organ().severed.count() > 0);
  simulation.restore(whole.save());
  CHECK(simulation.organ().severed.count() == 0);
  CHECK(simulation.stateHash() == whole.stateHash());
}

TEST_CASE("leaps between states, cut and dissolved, give the surface of each bit for bit") {
  std::vector<std::unique_ptr<Tool>> tools;
  tools.push_back(test::thinScalpel());
  tools.push_back(test::ballTool(0.01));
  Simulation simulation = test::elasticBlock({10, 5, 8}, 0.008, std::move(tools));
  simulation.keepLook();
  struct Moment {
    Bytes saved;
    std::uint64_t hash;
    SurfaceTracker::Compact surface;
  };
  std::vector<Moment> moments;
  const auto same = [](const SurfaceTracker::Compact& a, const SurfaceTracker::Compact& b) {
    return a.mesh.points == b.mesh.points && a.normals == b.normals && a.cut == b.cut;
  };
  Random random(5);
  FrameInput input;
  input.tools.assign(2, {{Vec3(0, 1, 0), Eigen::Quaterniond::Identity()}, false});
  for (int k = 0; k < 12; ++k) {
    moments.push_back({simulation.save(), simulation.stateHash(), simulation.surface()});
    // In turn a cut and a hole, at random places.
    const Vec3 at(random.uniform(0.01, 0.07), 0.05, random.uniform(0, 0.06));
    input.iso = k == 7 ? 40.f : 50.f;
    ToolInput& tool = input.tools[std::size_t(k % 2)];
    tool.inHand = true;
    for (int frame = 0; frame < 10; ++frame) {
      tool.pose.position = at - Vec3(0, 0.002 * frame, 0);
      simulation.step(input);
    }
    tool.inHand = false;
  }
  const Organ& organ = simulation.organ();
  CHECK(organ.removed > 20);
  CHECK(organ.severed.count() > 100);
  for (int leap = 0; leap < 80; ++leap) {
    const Moment& to = moments[std::size_t(random.below(int(moments.size())))];
    simulation.restore(to.saved);
    REQUIRE(simulation.stateHash() == to.hash);
    REQUIRE(same(simulation.surface(), to.surface));
    if (leap % 3 == 0) simulation.step(input);
  }
}

TEST_CASE("leaps between states of a segment that is parted, with other iso levels between") {
  Scenario scenario = shipped("resect-segment-elastic");
  setSpacing(scenario, scenario.organs[0].source.spacing.value_or(0.01), 0.013);
  Simulation simulation = makeSimulation(scenario, readPlainMesh),
             other = makeSimulation(scenario, readPlainMesh);
  struct Moment {
    Bytes saved;
    std::uint64_t hash;
  };
  std::vector<Moment> moments;
  Random random(9);
  for (std::int64_t frame = 0; frame < 400; ++frame) {
    if (frame % 8 == 0) moments.push_back({simulation.save(), simulation.stateHash()});
    FrameInput input = frameInput(scenario, frame);
    if (random.below(40) == 0) input.iso = float(random.uniform(40, 60));
    simulation.step(input);
  }
  CHECK(simulation.organ().severed.count() > 100);
  int stopped = 0;
  for (int leap = 0; leap < 300; ++leap) {
    const int to = random.below(int(moments.size()));
    simulation.restore(moments[std::size_t(to)].saved);
    CAPTURE(leap);
    CAPTURE(to);
    REQUIRE(simulation.stateHash() == moments[std::size_t(to)].hash);
    if (leap % 2 == 0) {  // a step that is stopped somewhere leaves nothing behind
      std::atomic<bool> stop = false;
      std::thread stopper([&, after = random.below(4000)] {
        std::this_thread::sleep_for(std::chrono::microseconds(after));
        stop = true;
      });
      try {
        const StopBy by(stop);
        for (int k = 1; k < 20; ++k) stepFrame(simulation, scenario, 8 * to + k);
      } catch (const Cancelled&) {
        ++stopped;
      }
      stopper.join();
      simulation.restore(moments[std::size_t(to)].saved);
      REQUIRE(simulation.stateHash() == moments[std::size_t(to)].hash);
    }
    for (int k = random.below(4); k > 0; --k) {
      FrameInput input = frameInput(scenario, 8 * to + k);
      if (random.below(3) == 0) input.iso = float(random.uniform(40, 60));
      simulation.step(input);
    }
    other.restore(simulation.save());
    REQUIRE(other.stateHash() == simulation.stateHash());
  }
  CHECK(stopped > 20);
}

TEST_CASE("what is made from a restored state is what it was made from while it came about") {
  Simulation simulation = cutBlock();
  Simulation fresh = test::elasticBlock({10, 5, 8}, 0.008, test::ballTool(0.01));
  fresh.restore(simulation.save());
  const auto& a = static_cast<const ElasticTissue&>(simulation.tissue()).state();
  const auto& b = static_cast<const ElasticTissue&>(fresh.tissue()).state();
  CHECK(a.inverseMoment == b.inverseMoment);
  CHECK(a.skew == b.skew);
  CHECK(a.planeWeight == b.planeWeight);
  CHECK(a.kappa == b.kappa);
  CHECK(a.inverseMass == b.inverseMass);
  REQUIRE(a.chunks.size() == b.chunks.size());
  for (std::size_t i = 0; i < a.chunks.size(); ++i) {
    CHECK(a.chunks[i].start == b.chunks[i].start);
    CHECK(a.chunks[i].uneven == b.chunks[i].uneven);
    CHECK(a.chunks[i].whole == b.chunks[i].whole);
    CHECK(a.chunks[i].steered == b.chunks[i].steered);
  }
}

TEST_CASE(
    "every field of the state decides its digest, and a difference in it is told by its name") {
  Simulation simulation = cutBlock();
  const SavedState state = simulation.fields();
  int fields = 0;
  const std::function<void(SavedState&, StateColumn&, const std::string&)> flip =
      [&](SavedState& other, StateColumn& column, const std::string& path) {
        const std::string here = path.empty() ? column.name : path + "." + column.name;
        if (!column.data.empty()) {
          std::byte& byte = column.data[column.data.size() / 2];
          byte ^= std::byte(1);
          ++fields;
          const std::string difference = firstDifference(state, other).value_or("");
          CHECK_MESSAGE(difference.starts_with(here), here << " is told as " << difference);
          if (here == ".organs.tissue.u.1" || here == ".organs.organ.alive")
            CHECK(difference.find("cell (") != std::string::npos);
          byte ^= std::byte(1);
        }
        for (StateColumn& field : column.fields) flip(other, field, here);
      };
  SavedState other = state;
  flip(other, other.root, "");
  CHECK(fields > 50);
  CHECK(!firstDifference(state, other));
}

TEST_CASE("no field of a struct that holds state is left out of visit() and visitMade()") {
  Simulation simulation = cutBlock();
  const OperatedOrgan& organ = simulation.organs()[0];
  const auto& tissue = static_cast<const ElasticTissue&>(*organ.tissue);
  CHECK(test::uncoveredBytes(simulation) == "");
  CHECK(test::uncoveredBytes(organ) == "");
  CHECK(test::uncoveredBytes(organ.organ) == "");
  CHECK(test::uncoveredBytes(organ.organ.severed) == "");
  CHECK(test::uncoveredBytes(tissue.state()) == "");
  CHECK(test::uncoveredBytes(tissue) == "");
  CHECK(test::uncoveredBytes(StillTissue(organ.organ.rest.lattice, organ.organ.alive)) == "");
  CHECK(test::uncoveredBytes(simulation.tools()[0]) == "");
  // A struct with a field that nobody named is found.
  struct Forgetful {
    double named = 0, forgotten = 0;
    void visit(StateVisitor& v) { v("named", named); }
    void visitMade(StateVisitor&) {}
  };
  CHECK(test::uncoveredBytes(Forgetful()) == "bytes 8 to 16");
}

TEST_CASE("a state of another organ, cut off or damaged, is refused and changes nothing") {
  Simulation simulation = cutBlock();
  const Bytes saved = simulation.save();
  const std::uint64_t before = simulation.stateHash();
  Simulation larger = test::elasticBlock({11, 5, 8}, 0.008, test::ballTool(0.01));
  CHECK_THROWS_WITH_AS(larger.restore(saved),
                       "the state is that of another organ, or of one in cells of another size; "
                       "restore it into the operation that it was saved from",
                       Error);
  Simulation still(makeOrgan(test::fullBlock({10, 5, 8}, 0.008), {}), {});
  CHECK_THROWS_AS(still.restore(saved), Error);
  Random random(7);
  int refused = 0;
  for (int i = 0; i < 600; ++i) {
    Bytes damaged = saved;
    if (i % 3 == 0)
      damaged.resize(random.below(damaged.size()));
    else
      damaged[random.below(damaged.size())] ^= std::byte(1 << random.below(8));
    if (i >= 300) damaged = test::resealed(damaged);  // on purpose
    try {
      simulation.restore(damaged);
      simulation.restore(saved);  // a number has changed: a state all the same
    } catch (const Error& e) {
      ++refused;
      CHECK(std::string(e.what()).find('\n') == std::string::npos);
    }
    REQUIRE(simulation.stateHash() == before);
  }
  CHECK(refused > 400);
}

TEST_CASE("a state whose numbers do not agree with each other is refused and changes nothing") {
  Simulation simulation = cutBlock();
  const std::uint64_t before = simulation.stateHash();
  using Path = std::vector<const char*>;
  // The first number of each: of a cell beyond the lattice, of a brick far from the cut.
  for (const Path& path :
       {Path{"organs", "tissue", "held"}, Path{"organs", "tissue", "loaded"},
        Path{"organs", "tissue", "material"}, Path{"organs", "tissue", "solid"},
        Path{"organs", "organ", "severed", "near"}, Path{"organs", "organ", "severed", "pendingOf"},
        Path{"organs", "organ", "severed", "count"}}) {
    SavedState state = simulation.fields();
    StateColumn* column = &state.root;
    for (const char* name : path)
      column = &*std::ranges::find(column->fields, name, &StateColumn::name);
    CAPTURE(column->name);
    column->data[0] ^= std::byte(1);
    CHECK_THROWS_AS(simulation.restore(toBytes(state)), Error);
    CHECK(simulation.stateHash() == before);
  }
}

TEST_CASE("a saved state is small, and saving and restoring are quick") {
  struct Case {
    const char* name;
    bool elastic;
    double spacing, bytesPerParticle;
  };
  // At most 96 bytes a particle of elastic tissue with two Maxwell branches, a bit of still tissue.
  for (const Case& c : {Case{"press", true, 0.005, 96}, Case{"cut", false, 0.00118, 0.125}}) {
    Scenario scenario = shipped(c.name);
    scenario.organs[0].source.spacing = c.spacing;
    Simulation simulation = makeSimulation(scenario, readPlainMesh);
    for (std::int64_t frame = 0; frame < 40; ++frame) stepFrame(simulation, scenario, frame);
    Bytes saved;
    const double save = millisecondsOf([&] { saved = simulation.save(); });
    const double restore = millisecondsOf([&] { simulation.restore(saved); });
    const double each = double(saved.size()) / double(simulation.organ().particles);
    MESSAGE(fmt::format(
        "{}: {} particles, {:.2f} bytes each, saved in {:.2f} ms, restored in {:.2f} ms", c.name,
        simulation.organ().particles, each, save, restore));
    CHECK(each < c.bytesPerParticle);
  }
}
