// Any moment of an operation is shown again, bit for bit; strokes are taken back and done again.
#include <doctest/doctest.h>

#include <cstdlib>
#include <map>
#include <utility>

#include "base/error.h"
#include "base/random.h"
#include "geometry/primitives.h"
#include "operation/live/operation_history.h"
#include "support/elastic_block.h"
#include "support/test_tools.h"
#include "tools/registry.h"

using namespace resect;

namespace {

// An operation with its history, which knows the state of each moment.
struct Operation {
  Simulation simulation = test::elasticBlock({8, 4, 6}, 0.008, test::thinScalpel());
  OperationHistory history{simulation, 60};
  std::map<std::pair<std::int64_t, std::int64_t>, std::uint64_t> known;  // by branch and frame
  StepReport report;
  bool letsGo = false;

  Operation() { note(); }
  void note() {
    const Moment now = history.now();
    known[{now.branch, now.frame}] = simulation.stateHash();
  }
  void step(const Vec3& tip, bool inHand = true) {
    FrameInput input;
    input.tools = {{{tip, Eigen::Quaterniond::Identity()}, inHand}};
    input.strokeEnds = std::exchange(letsGo, false);
    if (history.beforeStep(input, simulation)) note();
    simulation.step(input, report);
    history.afterStep(input, report, simulation);
    note();
  }
  // The simulation is in the state that its moment had.
  void check() {
    const Moment now = history.now();
    REQUIRE(now.frame == simulation.frame());
    const auto at = known.find({now.branch, now.frame});
    REQUIRE(at != known.end());
    CHECK(at->second == simulation.stateHash());
  }
  bool undo() {
    const Moment from = history.now();
    const auto moment = history.undoMoment();
    if (!moment) return false;
    history.goTo(*moment, simulation);
    history.undone(from);
    check();
    return true;
  }
  bool redo() {
    const auto moment = history.redoMoment();
    if (!moment) return false;
    history.goTo(*moment, simulation);
    history.redone();
    check();
    return true;
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
};

}  // namespace

TEST_CASE("a stroke is taken back to before its first contact, and done again") {
  Operation op;
  op.wait(3);
  CHECK_FALSE(op.undo());
  CHECK_FALSE(op.redo());
  op.stroke(0.03, 0.012, 0.004);
  REQUIRE(op.history.undoable() == 1);
  const std::uint64_t after = op.simulation.stateHash();
  const std::int64_t end = op.simulation.frame();
  CHECK(op.undo());
  CHECK(op.simulation.frame() < end - 20);
  CHECK(op.history.undoable() == 0);
  CHECK(op.redo());
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
  CHECK(op.undo());
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
  op.letsGo = true;
  for (int i = 0; i < 10; ++i) op.step(inside);
  CHECK(op.history.undoable() == 1);
  for (int i = 0; i <= 4; ++i) op.step(inside + Vec3(0.002 * i, 0, 0));
  CHECK(op.history.undoable() == 2);
  CHECK(op.undo());
  CHECK(op.undo());
  CHECK(op.simulation.frame() < 8);
}

TEST_CASE("undo and redo stay on the branch; working on from an earlier moment begins another") {
  Operation op;
  op.wait(3);
  op.stroke(0.03, 0.012, 0.004);
  op.wait(5);
  const Moment end = op.history.now();
  op.undo();
  CHECK(op.history.now().branch == 0);
  op.redo();
  CHECK(op.history.now() == end);
  op.wait(4);  // at the end of the branch: it goes on
  CHECK(op.history.courses().size() == 1);
  op.history.goTo({0, 9}, op.simulation);
  op.check();
  op.stroke(0.05, 0.012, 0.004);
  REQUIRE(op.history.courses().size() == 2);
  const Branch branch = op.history.courses()[1].branch;
  CHECK(branch.parent == 0);
  CHECK(branch.from == 9);
  CHECK(branch.name == "1, from 0:00");
  CHECK(op.history.undoable() == 1);  // the stroke of branch 0 lies beyond its frame 9
  op.undo();
  op.history.goTo(end, op.simulation);
  op.check();
  CHECK(op.history.undoable() == 1);
}

TEST_CASE("every moment of every branch is reached, whatever was shown before") {
  Operation op;
  op.wait(2);
  op.stroke(0.02, 0.012, 0.004);
  op.stroke(0.04, 0.012, 0.004);
  op.history.goTo({0, 30}, op.simulation);
  op.stroke(0.03, 0.016, -0.004);
  op.history.goTo({1, 45}, op.simulation);
  op.stroke(0.05, 0.016, 0.004);
  CHECK(op.history.courses().size() == 3);
  Random random(3);
  for (int i = 0; i < 60; ++i) {
    const auto branch = std::size_t(random.below(3));
    const auto& course = op.history.courses()[branch];
    const std::int64_t length = course.end() - course.branch.from;
    const Moment moment{std::int64_t(branch), course.branch.from + random.below(int(length) + 1)};
    op.history.goTo(moment, op.simulation);
    CHECK(op.history.now() == moment);
    op.check();
    for (int k = random.below(4);
         k > 0 && op.history.playNext(op.simulation, op.report, moment.branch); --k)
      op.check();
  }
  CHECK_THROWS_AS(op.history.goTo({3, 1}, op.simulation), Error);
  CHECK_THROWS_AS(op.history.goTo({2, 0}, op.simulation), Error);
  CHECK_THROWS_AS(op.history.goTo({0, 100'000}, op.simulation), Error);
  op.check();
}

TEST_CASE(
    "strokes, undo, redo and other moments in any order give equal states, in bounded memory") {
  // 1 000 strokes: RESECT_LONG_TESTS=1
  const int turns = std::getenv("RESECT_LONG_TESTS") ? 3000 : 120;
  constexpr std::size_t kMost = 1'000'000;
  Operation op;
  op.history = OperationHistory(op.simulation, 60, kMost);
  Random random(7);
  int strokes = 0, undone = 0, redone = 0, shown = 0;
  for (int i = 0; i < turns; ++i) {
    const int what = random.below(12);
    if (what < 4) {
      op.stroke(random.uniform(0.005, 0.06), random.uniform(-0.01, 0.02),
                random.uniform(-0.01, 0.01));
      ++strokes;
    } else if (what < 8 && op.history.undoable() > 0) {
      CHECK(op.undo());
      ++undone;
    } else if (what < 10 && op.history.redoable() > 0) {
      CHECK(op.redo());
      ++redone;
    } else if (what == 10) {
      const auto& courses = op.history.courses();
      const auto& course = courses[std::size_t(random.below(int(courses.size())))];
      const auto length = int(course.end() - course.branch.from);
      op.history.goTo({course.branch.number, course.branch.from + random.below(length + 1)},
                      op.simulation);
      op.check();
      ++shown;
    } else {
      op.wait(random.below(4));
    }
    // The first state of a branch stays.
    CHECK(op.history.bytes() <= std::max(kMost, 40'000 * op.history.courses().size()));
  }
  MESSAGE(strokes << " strokes, " << undone << " undone, " << redone << " done again, " << shown
                  << " moments, " << op.history.courses().size() << " branches, "
                  << op.history.bytes() << " bytes");
  CHECK(strokes > 20);
  CHECK(undone > 10);
  CHECK(redone >= 5);
}
