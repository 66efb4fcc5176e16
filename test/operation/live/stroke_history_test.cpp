// Strokes are taken back and done again, bit for bit.
#include <doctest/doctest.h>

#include <map>

#include "base/random.h"
#include "geometry/primitives.h"
#include "operation/live/stroke_history.h"
#include "support/elastic_block.h"
#include "tools/registry.h"

using namespace resect;

namespace {

std::unique_ptr<Tool> scalpel() {
  ToolModel model;
  model.name = model.kind = "scalpel";
  model.mesh = boxMesh({{-0.0002, -0.008, 0}, {0.0002, 0.002, 0.06}});
  model.edge = {{0, -0.008, 0}, {0, -0.0082, 0.03}, {0, -0.008, 0.06}};
  return makeTool(std::move(model));
}

// An operation with its history, which knows the state of each frame on the way it came.
struct Operation {
  Simulation simulation = test::elasticBlock({8, 4, 6}, 0.008, scalpel());
  StrokeHistory history;
  std::map<std::int64_t, std::uint64_t> way;  // state by frame
  StepReport report;

  void step(const Vec3& tip, bool inHand = true) {
    FrameInput input;
    input.tools = {{{tip, Eigen::Quaterniond::Identity()}, inHand}};
    history.beforeStep(input, simulation);
    simulation.step(input, report);
    history.afterStep(input, report);
    way[simulation.frame()] = simulation.stateHash();
  }
  void wait(int frames) {
    for (int i = 0; i < frames; ++i) step({0.03, 0.2, 0}, false);
  }
  // From above into the block and along, or beside it; `deep`: m below the top.
  void stroke(double x, double deep, double along) {
    const Vec3 above(x, 0.06, -0.005);
    for (int i = 0; i < 4; ++i) step(above);
    for (int i = 1; i <= 10; ++i) step(above - Vec3(0, (0.028 + deep) * i / 10, 0));
    for (int i = 1; i <= 6; ++i) step(above + Vec3(along * i / 6, -0.028 - deep, 0));
    for (int i = 1; i <= 6; ++i) step(above + Vec3(along, (-0.028 - deep) * (6 - i) / 6, 0));
    wait(8);  // put back: the stroke ends
  }
  // Checks that the state is one of the way, forgets what came after it.
  void wentBack() {
    const std::int64_t frame = simulation.frame();
    REQUIRE(way.contains(frame));
    CHECK(way[frame] == simulation.stateHash());
    way.erase(way.upper_bound(frame), way.end());
  }
};

}  // namespace

TEST_CASE("a stroke is taken back to before its first contact, and done again") {
  Operation op;
  op.wait(3);
  CHECK_FALSE(op.history.undo(op.simulation));
  CHECK_FALSE(op.history.redo(op.simulation));
  op.stroke(0.03, 0.012, 0.004);
  REQUIRE(op.history.undoable() == 1);
  const std::uint64_t after = op.simulation.stateHash();
  const std::int64_t end = op.simulation.frame();
  CHECK(op.history.undo(op.simulation));
  op.wentBack();
  CHECK(op.simulation.frame() < end - 20);
  CHECK(op.history.undoable() == 0);
  CHECK(op.history.redo(op.simulation));
  CHECK(op.simulation.stateHash() == after);
  CHECK(op.history.undoable() == 1);
}

TEST_CASE("strokes beside the organ are none, and a new stroke ends what can be done again") {
  Operation op;
  op.stroke(0.03, -0.02, 0.004);
  CHECK(op.history.undoable() == 0);
  op.stroke(0.03, 0.012, 0.004);
  op.stroke(0.05, 0.012, 0.004);
  CHECK(op.history.undoable() == 2);
  CHECK(op.history.undo(op.simulation));
  op.wentBack();
  CHECK(op.history.redoable() == 1);
  op.stroke(0.02, 0.012, 0.004);
  CHECK(op.history.redoable() == 0);
  CHECK(op.history.undoable() == 2);
}

TEST_CASE("a stroke ends when the button is released, and the next one when the tool moves again") {
  Operation op;
  const Vec3 above(0.03, 0.06, -0.005), inside = above - Vec3(0, 0.04, 0);
  for (int i = 0; i <= 10; ++i) op.step(above + (inside - above) * i / 10);
  CHECK(op.history.undoable() == 1);
  op.history.endStroke();
  for (int i = 0; i < 10; ++i) op.step(inside);
  CHECK(op.history.undoable() == 1);
  for (int i = 0; i <= 4; ++i) op.step(inside + Vec3(0.002 * i, 0, 0));
  CHECK(op.history.undoable() == 2);
  CHECK(op.history.undo(op.simulation));
  op.wentBack();
  CHECK(op.history.undo(op.simulation));
  op.wentBack();
  CHECK(op.simulation.frame() < 8);
}

TEST_CASE("strokes, undo and redo in any order give equal states, in bounded memory") {
  Operation op;
  op.history = StrokeHistory(1'000'000);
  Random random(7);
  std::vector<std::uint64_t> ends;  // states in which undo was called
  int strokes = 0, undone = 0, redone = 0;
  for (int i = 0; i < 120; ++i) {
    const int what = random.below(5);
    if (what < 2) {
      op.stroke(random.uniform(0.005, 0.06), random.uniform(-0.01, 0.02),
                random.uniform(-0.01, 0.01));
      if (op.history.redoable() == 0) ends.clear();
      ++strokes;
    } else if (what < 4 && op.history.undoable() > 0) {
      ends.push_back(op.simulation.stateHash());
      CHECK(op.history.undo(op.simulation));
      op.wentBack();
      ++undone;
    } else if (op.history.redoable() > 0) {
      CHECK(op.history.redo(op.simulation));
      CHECK(op.simulation.stateHash() == ends.back());
      ends.pop_back();
      op.way[op.simulation.frame()] = op.simulation.stateHash();
      ++redone;
    } else {
      op.wait(random.below(4));
    }
    CHECK(op.history.bytes() <= 1'000'000);
  }
  CHECK(strokes > 20);
  CHECK(undone > 10);
  CHECK(redone >= 5);
}
