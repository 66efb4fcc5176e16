#include "operation/live/strokes.h"

#include <doctest/doctest.h>

using namespace resect;

namespace {

// Two tools, and the events that they cause.
struct Hands {
  StrokeTracker tracker;
  FrameInput input;
  std::int64_t frame = 0;

  Hands() {
    input.duration = 1.0 / 60;
    input.tools.resize(2);
  }
  void step(std::vector<OperationEvent> events = {}) {
    tracker.add(++frame, input, events);
    input.strokeEnds = false;
  }
  void move(int tool) { input.tools[std::size_t(tool)].pose.position.x() += 0.001; }
  static OperationEvent event(const char* kind, std::int64_t tool, double amount = 0) {
    OperationEvent e;
    e.kind = kind, e.tool = tool, e.amount = amount;
    return e;
  }
};

}  // namespace

TEST_CASE("a tool that lags behind the hand when it is left is left all the same") {
  Hands hands;
  hands.input.tools[1].inHand = true;
  hands.move(1);
  hands.step({Hands::event("take", 1), Hands::event("touch", 1)});
  hands.input.strokeEnds = true;
  for (int i = 0; i < 15; ++i) {  // 15 mm in a quarter of a second
    hands.move(1);
    hands.step();
  }
  CHECK_FALSE(hands.tracker.inStroke());
  for (int i = 0; i < 20; ++i) {
    hands.move(0);
    hands.step();
  }
  hands.input.tools[0].inHand = true;
  hands.step({Hands::event("take", 0), Hands::event("touch", 0)});
  REQUIRE(hands.tracker.strokes().size() == 2);
  CHECK(hands.tracker.strokes()[1].tool == 0);
}

TEST_CASE("a tool that was left holding takes no part in the strokes of the other") {
  Hands hands;
  hands.input.tools[1].inHand = true;
  hands.step({Hands::event("take", 1)});
  hands.move(1);
  hands.step({Hands::event("touch", 1)});
  CHECK(hands.tracker.inStroke());
  hands.input.strokeEnds = true;  // it is left where it is
  hands.step();
  CHECK_FALSE(hands.tracker.inStroke());
  for (int i = 0; i < 100; ++i) {
    hands.move(0);  // the other one hovers
    hands.step();
  }
  CHECK_FALSE(hands.tracker.inStroke());
  REQUIRE(hands.tracker.strokes().size() == 1);

  hands.input.tools[0].inHand = true;
  hands.move(0);
  hands.step({Hands::event("take", 0), Hands::event("touch", 0)});
  hands.move(0);
  hands.step({Hands::event("cut", -1, 3)});
  hands.input.strokeEnds = true;
  hands.input.tools[0].inHand = false;
  hands.step({Hands::event("release", 0), Hands::event("put_back", 0)});
  hands.step();
  REQUIRE(hands.tracker.strokes().size() == 2);
  CHECK(hands.tracker.strokes()[0].tool == 1);
  CHECK(hands.tracker.strokes()[1].tool == 0);
  CHECK(hands.tracker.strokes()[1].severed == 3);
  CHECK_FALSE(hands.tracker.inStroke());

  // It is moved again, some time after it was left: a stroke.
  for (int i = 0; i < 20; ++i) hands.step();
  for (int i = 0; i < 8; ++i) {
    CHECK_FALSE(hands.tracker.inStroke());
    hands.move(1);
    hands.step();
  }
  CHECK(hands.tracker.inStroke());
}
