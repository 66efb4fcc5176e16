// Tissue forceps on a floating block of elastic tissue, 80 x 40 x 64 mm, whose top is at y = 0.04.
#include <doctest/doctest.h>

#include <numbers>

#include "simulation/simulation.h"
#include "support/elastic_block.h"
#include "support/test_tools.h"

using namespace resect;

namespace {

// Turned by `turn` about the vertical through the tip: the handle points upwards, and the jaws move
// in another plane.
struct Hand {
  Simulation simulation;
  Eigen::Quaterniond turn;
  Vec3 tip = Vec3(0.041, 0.09, 0.031);
  double squeeze = 0;

  explicit Hand(double degrees = 0, double slipForce = 3)
      : simulation(test::elasticBlock(
            {10, 5, 8}, 0.008,
            test::describedTool("forceps", boxMesh({{-0.001, -0.001, 0}, {0.001, 0.001, 0.06}}),
                                [&](ToolModel& m) {
                                  m.jaws.pivot = Vec3(0, 0, 0.05);
                                  m.jaws.opening = 0.1;
                                  m.slipForce = slipForce;
                                }))),
        turn(Eigen::AngleAxisd(degrees * std::numbers::pi / 180, Vec3::UnitY()) *
             Eigen::AngleAxisd(-0.5 * std::numbers::pi, Vec3::UnitX())) {}

  void to(const Vec3& place, double closed, int frames) {
    const Vec3 from = tip;
    const double before = squeeze;
    for (int i = 1; i <= frames; ++i) {
      const double share = double(i) / frames;
      tip = from + share * (place - from);
      squeeze = before + share * (closed - before);
      FrameInput input;
      input.tools = {{{tip, turn}, true, squeeze}};
      simulation.step(input);
    }
  }
  // To the middle of the block's top.
  void down(double closed = 0) { to({0.041, 0.0395, 0.031}, closed, 20); }
  int held() const { return simulation.organs()[0].tissue->gripped(0); }
  double heightOfTop() const {
    const auto points = simulation.organs()[0].points();
    double most = -1;
    for (const Vec3f& p : points) most = std::max(most, double(p.y()));
    return most;
  }
};

}  // namespace

TEST_CASE("forceps that close on tissue lift it, and release it as they open") {
  for (const double degrees : {0.0, 40.0}) {
    CAPTURE(degrees);
    Hand hand(degrees);
    hand.down();
    CHECK(hand.held() == 0);
    hand.to(hand.tip, 1, 6);
    CHECK(hand.held() >= 4);
    const double before = hand.heightOfTop();
    hand.to(hand.tip + Vec3(0, 0.012, 0), 1, 40);
    CHECK(hand.held() >= 4);
    CHECK(hand.heightOfTop() > before + 0.009);
    hand.to(hand.tip, 0, 6);
    CHECK(hand.held() == 0);
  }
}

TEST_CASE("forceps that close beside tissue hold none, nor what they meet while they are closed") {
  Hand hand;
  hand.to(hand.tip, 1, 6);
  CHECK(hand.held() == 0);
  hand.down(1);
  hand.to(hand.tip + Vec3(0.004, -0.002, 0), 1, 10);
  CHECK(hand.held() == 0);
  // Opened and closed again where they are now, they hold.
  hand.to(hand.tip, 0, 6);
  hand.to(hand.tip, 1, 6);
  CHECK(hand.held() > 0);
}

TEST_CASE("forceps slip off at their limit") {
  Hand hand(0, 0.2);
  hand.down();
  hand.to(hand.tip, 1, 6);
  REQUIRE(hand.held() > 0);
  hand.to(hand.tip + Vec3(0, 0.05, 0), 1, 20);
  CHECK(hand.held() == 0);
}
