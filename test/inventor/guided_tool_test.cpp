// A mouse that guides instruments over living tissue.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "inventor/gl/SoOrganShape.h"
#include "inventor/hand/operating_session.h"
#include "inventor/hand/pointed_surface.h"
#include "support/operating_bench.h"

using namespace resect;

namespace {

constexpr int kScalpel = 0, kHook = 1, kScissors = 3;

struct GuidedBench : test::OperatingBench {
  explicit GuidedBench(double spacing = 0.012) : OperatingBench(true, spacing) {
    session->viewAll(1.6);
    session->operation().waitFor(40);  // the liver has sunk
    session->update();
  }

  SbVec2s onOrgan(double right = 0, double up = 0) const {
    const SbVec2s middle = session->pixelOf(pointOfOrgan(), viewport);
    return {short(middle[0] + right), short(middle[1] + up)};
  }
  void take(int tool, const SbVec2s& at) {
    move(at);
    SoKeyboardEvent event;
    event.setKey(SoKeyboardEvent::Key(int(SoKeyboardEvent::NUMBER_1) + tool));
    event.setState(SoButtonEvent::DOWN);
    send(event, at);
    REQUIRE(tools().held() == tool);
    REQUIRE(tools().how() == ToolHandling::Hold::Guided);
  }
  void press(const SbVec2s& at) { button(at, true, SoMouseButtonEvent::BUTTON1); }
  void release(const SbVec2s& at) { button(at, false, SoMouseButtonEvent::BUTTON1); }
  // At the pace of a hand.
  void draw(const SbVec2s& from, const SbVec2s& to) {
    constexpr int kSteps = 25;
    for (int i = 1; i <= kSteps; ++i) {
      move(SbVec2s(short(from[0] + (to[0] - from[0]) * i / kSteps),
                   short(from[1] + (to[1] - from[1]) * i / kSteps)));
      settle();
    }
  }
  double cutArea() {
    const auto ledger = session->state().ledger;
    return ledger ? ledger->cut() : 0;
  }
  void waitSeconds(double seconds) {
    session->operation().waitFor(session->state().frame + std::int64_t(60 * seconds));
    session->update();
  }
};

// Numbers of corners of the holes that cuts have made in the skin.
std::vector<int> holesIn(SoOrganShape& organ) {
  const SurfaceCopy surface = organ.snapshot().first;
  std::map<std::pair<std::int32_t, std::int32_t>, int> edges;
  for (const Triangle& t : surface.triangles) {
    const auto skin = [&](std::int32_t v) { return surface.cut[std::size_t(v)] <= 0; };
    if (t[0] == t[1] || !std::ranges::all_of(t, skin)) continue;
    for (std::size_t k = 0; k < 3; ++k) ++edges[std::minmax(t[k], t[(k + 1) % 3])];
  }
  std::map<std::int32_t, std::int32_t> next;  // union of the corners along the borders
  const auto last = [&](std::int32_t v) {
    while (next.contains(v) && next[v] != v) v = next[v];
    return v;
  };
  for (const auto& [edge, uses] : edges)
    if (uses == 1)
      next[last(edge.first)] = last(edge.second), next.try_emplace(edge.second, edge.second);
  std::map<std::int32_t, int> corners;
  for (const auto& [v, other] : next) ++corners[last(v)];
  std::vector<int> holes;
  for (const auto& [v, count] : corners) holes.push_back(count);
  return holes;
}

// Strokes over the dome and a lobe, along and across: ways from the organ's middle, pixels.
const std::pair<SbVec2s, SbVec2s> kStrokes[] = {{SbVec2s(-60, 30), SbVec2s(-20, -10)},
                                                {SbVec2s(-10, 35), SbVec2s(0, -20)},
                                                {SbVec2s(10, -10), SbVec2s(60, -25)}};

// Draws a stroke with the scalpel. notches: turned at the wheel before it, towards less depth.
// Returns the largest hole's share of the rims of all holes that are then in the skin.
double strokeOf(GuidedBench& bench, const std::pair<SbVec2s, SbVec2s>& stroke, int notches) {
  const auto& [from, to] = stroke;
  const SbVec2s begin = bench.onOrgan(from[0], from[1]), end = bench.onOrgan(to[0], to[1]);
  bench.take(kScalpel, begin);
  for (int i = 0; i < notches; ++i) bench.button(begin, true, SoMouseButtonEvent::BUTTON5);
  bench.press(begin);
  bench.draw(begin, end);
  bench.release(end);
  bench.waitSeconds(1.2);
  const std::vector<int> holes = holesIn(*bench.session->room().organ());
  REQUIRE_FALSE(holes.empty());
  int corners = 0;
  for (const int count : holes) corners += count;
  const double share = double(std::ranges::max(holes)) / corners;
  MESSAGE(holes.size(), " holes, the largest has ", 100 * share, " % of the rim");
  return share;
}

// Area that a stroke cuts that is drawn down over the far rim, which is seen against the room. It
// begins 12 pixels inside the rim, or beside the organ.
double strokeOverTheRim(bool beside, bool slowly) {
  GuidedBench bench(0.008);
  const SbVec2s to = bench.onOrgan(0, -20);
  SbVec2s rim = bench.onOrgan();
  const auto onTable = [&] {
    const auto under = bench.session->pointUnder(rim, bench.viewport);
    return !under || under->point.y() < 1e-6;
  };
  while (!onTable() && rim[1] < 480) ++rim[1];
  SbVec2s from(rim[0], short(rim[1] + (beside ? 12 : -12)));
  bench.take(kScalpel, from);
  bench.press(from);
  if (beside) {  // what is drawn beside the organ is not told as a stroke
    const SbVec2s nearer(from[0], short(from[1] - 5));
    bench.draw(from, nearer);
    CHECK(bench.tools().surfaceHand()->stroke == 0);
    from = nearer;
  }
  const int piece = slowly ? 8 : 1000;  // pixels that are drawn in 50 frames
  while (from[1] > to[1]) {
    const SbVec2s next(from[0], short(std::max<int>(to[1], from[1] - piece)));
    bench.draw(from, next);
    from = next;
  }
  CHECK(bench.tools().surfaceHand()->stroke > 0.02);
  bench.release(to);
  bench.waitSeconds(1);
  return bench.cutArea();
}

}  // namespace

TEST_CASE("a stroke over the dome or a lobe, along or across, opens the skin in one line") {
  for (const double spacing : {0.008, 0.006})
    for (const auto& stroke : kStrokes) {
      CAPTURE(spacing);
      GuidedBench bench(spacing);
      CHECK(strokeOf(bench, stroke, 0) > 0.4);
      CHECK(bench.cutArea() > 2e-4);
    }
}

TEST_CASE("a stroke cuts about as deep as is set") {
  for (const int stroke : {1, 2})
    for (const int notches : {0, 2}) {
      GuidedBench bench(0.008);
      const auto& [from, to] = kStrokes[stroke];
      const auto begin = bench.session->pointUnder(bench.onOrgan(from[0], from[1]), bench.viewport),
                 end = bench.session->pointUnder(bench.onOrgan(to[0], to[1]), bench.viewport);
      REQUIRE((begin && end));
      const double length = (end->point - begin->point).norm();
      strokeOf(bench, kStrokes[stroke], notches);
      const double share = bench.cutArea() / length / bench.tools().depth(kScalpel);
      MESSAGE("set ", 1e3 * bench.tools().depth(kScalpel), " mm: ", 100 * share, " % of it is cut");
      CHECK(share > 0.75);
      CHECK(share < 1);
    }
}

TEST_CASE(
    "the wheel takes the scalpel no shallower than a stroke that opens the skin in one line") {
  for (const auto& stroke : kStrokes) {
    GuidedBench bench(0.008);
    CHECK(strokeOf(bench, stroke, 8) > 0.4);
    CHECK(bench.tools().depth(kScalpel) == doctest::Approx(0.004));
    CHECK(bench.tools().isLeastDeep(kScalpel));
  }
}

TEST_CASE("an instrument in hand hovers over the surface under the pointer") {
  GuidedBench bench;
  const SbVec2s at = bench.onOrgan();
  bench.take(kScalpel, at);
  for (const SbVec2s& to : {at, bench.onOrgan(-30, 10), bench.onOrgan(40, -20)}) {
    bench.move(to);
    const auto under = bench.session->pointUnder(to, bench.viewport);
    REQUIRE(under);
    const Vec3 tip = bench.tools().pose(kScalpel).position;
    const double height = (tip - under->point).norm();
    CHECK(height > 0.003);
    CHECK(height < 0.008);
  }
  bench.waitSeconds(0.2);
  CHECK(bench.session->state().peakForces[kScalpel] == 0);
  CHECK(bench.cutArea() == 0);
}

TEST_CASE(
    "pressing and drawing cuts a continuous line, releasing ends it, and undo takes it back") {
  GuidedBench bench;
  const SbVec2s from = bench.onOrgan(-30, 15), to = bench.onOrgan(30, -15);
  bench.take(kScalpel, from);
  bench.press(from);
  CHECK(bench.tools().pressing());
  bench.draw(from, to);
  CHECK(bench.session->state().touching[kScalpel]);
  const Vec3 working = bench.tools().pose(kScalpel).position;
  bench.release(to);
  CHECK_FALSE(bench.tools().pressing());
  CHECK((bench.tools().pose(kScalpel).position - working).norm() > 0.01);  // it is lifted out
  bench.waitSeconds(1.5);
  CHECK(bench.cutArea() > 2e-4);
  CHECK(bench.session->state().removed == 0);
  CHECK(bench.session->state().undoable == 1);

  bench.session->undo();
  bench.session->operation().waitForAnswer();
  bench.session->update();
  CHECK(bench.session->showing());
  CHECK(bench.cutArea() == 0);
  // Hovering looks on; the next press goes on from there.
  bench.move(bench.onOrgan(-10, 10));
  CHECK(bench.session->showing());
  bench.press(bench.onOrgan(-10, 10));
  bench.settle();
  CHECK_FALSE(bench.session->showing());
  bench.release(bench.onOrgan(-10, 10));
}

TEST_CASE("a stroke that begins beside the organ cuts the rim, too") {
  const double inside = strokeOverTheRim(false, true), over = strokeOverTheRim(true, true);
  MESSAGE("cut: ", 1e4 * inside, " and ", 1e4 * over, " cm^2");
  CHECK(inside > 3e-4);
  CHECK(over > 1.5 * inside);
  // At 0.3 m/s the rim, a thin sheet, gives way, and the cut begins behind it.
  const double fast = strokeOverTheRim(true, false);
  MESSAGE("fast: ", 1e4 * fast, " cm^2");
  CHECK(fast > 0.6 * inside);
}

TEST_CASE("a stroke after an undo begins where the hand presses, not where the instrument was") {
  GuidedBench bench;
  const SbVec2s first = bench.onOrgan(-45, 15), firstEnd = bench.onOrgan(-35, -10);
  bench.take(kScalpel, first);
  bench.press(first);
  bench.draw(first, firstEnd);
  bench.release(firstEnd);
  bench.waitSeconds(0.6);
  bench.session->undo();
  bench.session->operation().waitForAnswer();
  bench.session->update();
  // In the moment that is shown, the scalpel may be in hand at the start of the first stroke.
  REQUIRE(bench.tools().held() == kScalpel);
  const SbVec2s at = bench.onOrgan(30, 5);
  const Vec3 there = bench.session->pointUnder(at, bench.viewport)->point;
  bench.press(at);
  for (int i = 0; i < 10; ++i) {
    bench.settle();
    const LiveState& state = bench.session->state();
    if (state.inHand[kScalpel]) CHECK((state.poses[kScalpel].position - there).norm() < 0.02);
  }
  bench.draw(at, bench.onOrgan(45, -5));
  bench.release(bench.onOrgan(45, -5));
  bench.waitSeconds(0.5);
  CHECK(bench.cutArea() > 1e-4);
}

TEST_CASE("an instrument moves no faster than a hand while it works") {
  GuidedBench bench;
  const SbVec2s from = bench.onOrgan(-40, 0), to = bench.onOrgan(40, 0);
  bench.take(kScalpel, from);
  bench.press(from);
  bench.settle();
  bench.move(to);  // in one event
  Vec3 before = bench.tools().pose(kScalpel).position;
  std::int64_t frame = bench.session->state().frame;
  for (int i = 0; i < 10; ++i) {
    bench.settle();
    const Vec3 now = bench.session->state().poses[kScalpel].position;
    const std::int64_t frames = bench.session->state().frame - frame;
    if (i > 0) CHECK((now - before).norm() < 0.3 / 60 * double(frames) + 1e-6);
    before = now;
    frame = bench.session->state().frame;
  }
}

TEST_CASE("the wheel sets how deep an instrument works, and each keeps its depth") {
  GuidedBench bench;
  const SbVec2s at = bench.onOrgan();
  bench.take(kScalpel, at);
  const double depth = bench.tools().depth(kScalpel), hook = bench.tools().depth(kHook);
  for (int i = 0; i < 3; ++i) bench.button(at, true, SoMouseButtonEvent::BUTTON4);
  CHECK(bench.tools().depth(kScalpel) == doctest::Approx(depth + 0.006));
  const Vec3 heading = bench.tools().surfaceHand()->heading;
  bench.button(at, true, SoMouseButtonEvent::BUTTON4, true);  // with Shift
  CHECK(bench.tools().depth(kScalpel) == doctest::Approx(depth + 0.006));
  CHECK(heading.dot(bench.tools().surfaceHand()->heading) == doctest::Approx(std::cos(0.1)));
  bench.take(kHook, at);
  CHECK(bench.tools().depth(kHook) == hook);
  bench.take(kScalpel, at);
  CHECK(bench.tools().depth(kScalpel) == doctest::Approx(depth + 0.006));
  for (int i = 0; i < 10; ++i) {
    CHECK(bench.tools().isMostDeep(kScalpel) == (i >= 3));  // 22 mm; 24, 26, 27 mm
    bench.button(at, true, SoMouseButtonEvent::BUTTON4);
  }
  CHECK(bench.tools().depth(kScalpel) < 0.03);
}

TEST_CASE("a hook left holding holds while the scalpel cuts; taken again, it lets go") {
  GuidedBench bench;
  const SbVec2s from = bench.onOrgan(10, -5),
                to = bench.onOrgan(18, -5);  // gently: at 2 N it slips off
  bench.take(kHook, from);
  bench.press(from);
  bench.waitSeconds(0.4);
  bench.draw(from, to);
  REQUIRE(bench.session->state().forces[kHook] > 0.05);
  bench.key(SoKeyboardEvent::F);
  CHECK(bench.tools().held() == -1);
  CHECK(bench.tools().isLeft(kHook));
  bench.release(to);
  bench.waitSeconds(0.3);
  const Pose left = bench.tools().pose(kHook);
  const double torn = bench.cutArea();  // by the pull

  const SbVec2s start = bench.onOrgan(-10, 20), end = bench.onOrgan(-10, -20);
  bench.take(kScalpel, start);
  bench.press(start);
  bench.draw(start, end);
  bench.release(end);
  bench.waitSeconds(1.2);
  CHECK(bench.tools().isLeft(kHook));
  CHECK(bench.session->state().forces[kHook] > 0.05);
  CHECK((bench.tools().pose(kHook).position - left.position).norm() < 1e-6);
  CHECK(bench.cutArea() > torn + 1e-4);
  CHECK(bench.session->state().undoable == 2);  // the pull and the cut

  // The cut is taken back, and the hook still holds.
  bench.session->undo();
  bench.session->operation().waitForAnswer();
  bench.session->update();
  CHECK(bench.cutArea() == torn);
  CHECK(bench.tools().isLeft(kHook));
  CHECK(bench.tools().held() == kScalpel);
  bench.session->goOn();
  bench.waitSeconds(0.3);
  CHECK(bench.session->state().inHand[kHook]);

  bench.take(kHook, start);
  CHECK_FALSE(bench.tools().isLeft(kHook));
  bench.waitSeconds(0.3);
  CHECK(bench.session->state().forces[kHook] < 0.01);
}

TEST_CASE("in a wound a blade goes into the depth, on the skin at right angles to the skin") {
  GuidedBench bench(0.008);
  bench.take(kHook, bench.onOrgan(25, -5));
  bench.press(bench.onOrgan(25, -5));
  bench.waitSeconds(0.4);
  bench.draw(bench.onOrgan(25, -5), bench.onOrgan(40, -8));
  bench.key(SoKeyboardEvent::F);
  const SbVec2s from = bench.onOrgan(0, 25), to = bench.onOrgan(0, -25);
  bench.take(kScalpel, from);
  bench.press(from);
  bench.draw(from, to);
  bench.release(to);
  bench.waitSeconds(1.5);

  const PointedSurface pointed(bench.session->room());
  int walls = 0, skin = 0;
  for (int x = -40; x <= 40; x += 2)
    for (int y = -30; y <= 30; y += 2) {
      const SbVec2s at = bench.onOrgan(x, y);
      const auto face = pointed.under(at, bench.viewport);
      const auto blade = pointed.under(at, bench.viewport, true);
      REQUIRE(face);
      REQUIRE(blade);
      CHECK((face->point - blade->point).norm() < 1e-9);
      if ((face->normal - blade->normal).norm() < 1e-6) {
        ++skin;
      } else {
        ++walls;
        CHECK(blade->normal.y() > 0.6);
      }
    }
  MESSAGE(walls, " points in the wound, ", skin, " on the skin");
  CHECK(walls > 5);
  CHECK(skin > 200);
}

TEST_CASE("taking another instrument while one works leaves that one at work") {
  GuidedBench bench;
  const SbVec2s at = bench.onOrgan();
  bench.take(kHook, at);
  bench.press(at);
  bench.settle();
  bench.take(kScalpel, at);
  CHECK(bench.tools().isLeft(kHook));
  bench.tools().putBack(kHook);
  CHECK_FALSE(bench.tools().isLeft(kHook));
  // Nothing holds: there is nothing to leave.
  bench.key(SoKeyboardEvent::F);
  CHECK(bench.tools().held() == kScalpel);
}

TEST_CASE("pressing closes scissors") {
  GuidedBench bench;
  const SbVec2s at = bench.onOrgan();
  bench.take(kScissors, at);
  bench.waitSeconds(0.3);
  CHECK(bench.session->state().squeeze[kScissors] == 0);
  bench.press(at);
  bench.waitSeconds(0.4);
  CHECK(bench.session->state().squeeze[kScissors] == 1);
  bench.release(at);
  bench.waitSeconds(0.4);
  CHECK(bench.session->state().squeeze[kScissors] == 0);
}

TEST_CASE("a stroke goes on beside the organ, and a press on an instrument takes it") {
  GuidedBench bench;
  bench.move(bench.pixelOf(kHook));
  bench.press(bench.pixelOf(kHook));
  REQUIRE(bench.tools().held() == kHook);
  bench.release(bench.pixelOf(kHook));
  bench.take(kScalpel, bench.onOrgan());
  bench.press(bench.onOrgan());
  bench.move({5, 495});  // the wall
  CHECK(bench.tools().surfaceHand() != nullptr);
  CHECK(bench.tools().wanted(kScalpel).position.allFinite());
  bench.release({5, 495});
  // Freely, and along the surface again.
  bench.tools().hold(kScalpel, ToolHandling::Hold::Direct);
  CHECK(bench.tools().surfaceHand() == nullptr);
  bench.tools().hold(kScalpel, bench.tools().usual());
  bench.move(bench.onOrgan());
  CHECK(bench.tools().surfaceHand() != nullptr);
}
