#include "operation/hand/surface_hand.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.h"

using namespace resect;

namespace {

HandStyle styleOf(const std::string& kind) {
  ToolModel model;
  if (kind == "scalpel" || kind == "scissors") model.edge = {{0, 0, 0}, {0, -0.008, 0.03}};
  if (kind == "scissors") model.jaws.opening = 0.5;
  if (kind == "hook") model.hook = {{0, -0.01, 0.01}, {0, 0, 0}, {0, 0.01, 0.01}};
  return handStyleOf(model);
}

// Over a plane through the origin with this normal, from `from` to `to` in steps of a millimetre.
void draw(SurfaceHand& hand, const Vec3& normal, const Vec3& from, const Vec3& to) {
  const int steps = std::max(1, int(std::lround((to - from).norm() / 0.001)));
  for (int i = 0; i <= steps; ++i) pointAt(hand, {from + i * (to - from) / steps, normal});
}

// How far the tool's tip lies below the plane, m.
double depthOf(const SurfaceHand& hand, const Vec3& normal) {
  return -poseOf(hand).position.dot(normal);
}

}  // namespace

TEST_CASE("an instrument hovers over the surface, whichever way this faces") {
  for (const Vec3& normal :
       {Vec3(0, 1, 0), Vec3(0.6, 0.8, 0), Vec3(0, 0, 1), Vec3(-0.3, 0.5, -0.7).normalized()})
    for (const char* name : {"scalpel", "hook", "baton", "scissors"}) {
      CAPTURE(name);
      SurfaceHand hand = takeUp(styleOf(name), Vec3::UnitX());
      draw(hand, normal, Vec3::Zero(), 0.04 * normal.unitOrthogonal());
      CHECK(depthOf(hand, normal) == doctest::Approx(-hand.style.hover));
      // The handle is outside, and the heading in the surface.
      CHECK((poseOf(hand).rotation * Vec3::UnitZ()).dot(normal) > 0.3);
      CHECK(std::abs(hand.heading.dot(normal)) < 1e-9);
      CHECK(hand.heading.norm() == doctest::Approx(1));
    }
}

TEST_CASE("a blade enters where the hand presses, goes down on its way, and cuts towards it") {
  const Vec3 normal = Vec3(0.2, 1, -0.3).normalized(), way = normal.unitOrthogonal();
  for (const Vec3& towards : {way, Vec3(-way), Vec3(normal.cross(way))}) {
    SurfaceHand hand = takeUp(styleOf("scalpel"), Vec3::UnitZ());
    pointAt(hand, {Vec3::Zero(), normal});
    press(hand);
    CHECK(depthOf(hand, normal) < 0.0015);
    draw(hand, normal, Vec3::Zero(), 0.002 * towards);
    CHECK(depthOf(hand, normal) < 0.006);
    draw(hand, normal, 0.002 * towards, 0.008 * towards);  // a short stroke is deep enough, too
    CHECK(depthOf(hand, normal) == doctest::Approx(hand.depth));
    draw(hand, normal, 0.008 * towards, 0.05 * towards);
    CHECK(depthOf(hand, normal) == doctest::Approx(hand.depth));
    CHECK(hand.heading.dot(towards) > 0.99);
    // The edge, -y of the tool, faces that way, and the handle leans towards it.
    CHECK((poseOf(hand).rotation * -Vec3::UnitY()).dot(towards) > 0.7);
    CHECK((poseOf(hand).rotation * Vec3::UnitZ()).dot(towards) > 0.5);
    // The line of the tip along the handle meets the surface where the hand points.
    const Pose pose = poseOf(hand);
    const Vec3 handle = pose.rotation * Vec3::UnitZ();
    const Vec3 entry = pose.position + depthOf(hand, normal) / handle.dot(normal) * handle;
    CHECK((entry - 0.05 * towards).norm() < 1e-6);
    // The stroke is as long as the way, deeper or not, and until the next one begins.
    goDeeper(hand, 0.002);
    lift(hand);
    pointAt(hand, {0.06 * towards, normal});
    CHECK(hand.stroke == doctest::Approx(0.05));
    press(hand);
    CHECK(hand.stroke == 0);
  }
}

TEST_CASE("a quick stroke, whose first step is a centimetre long, cuts towards its way too") {
  const Vec3 normal = Vec3(0.2, 1, -0.3).normalized(), way = normal.unitOrthogonal();
  for (const Vec3& towards : {way, Vec3(-way), Vec3(normal.cross(way)), Vec3(-normal.cross(way))})
    for (const bool beside : {false, true}) {  // beside: it begins beside the organ
      SurfaceHand hand = takeUp(styleOf("scalpel"), Vec3::UnitZ());
      const Vec3 start = beside ? Vec3(0.1 * towards - 0.05 * normal) : Vec3(Vec3::Zero());
      pointAt(hand, {start, normal});
      press(hand);
      if (beside) landAt(hand, {Vec3::Zero(), normal});
      CHECK(hand.way == 0);
      for (int i = 1; i <= 5; ++i) pointAt(hand, {0.01 * i * towards, normal});
      CHECK(hand.heading.dot(towards) > 0.99);
      CHECK(depthOf(hand, normal) == doctest::Approx(hand.depth));
    }
}

TEST_CASE("a blade follows a bend, but does not turn round when it is drawn back") {
  const Vec3 up = Vec3::UnitY();
  SurfaceHand hand = takeUp(styleOf("scalpel"), Vec3::UnitX());
  pointAt(hand, {Vec3::Zero(), up});
  press(hand);
  draw(hand, up, Vec3::Zero(), Vec3(0.03, 0, 0));
  draw(hand, up, Vec3(0.03, 0, 0), Vec3(0.03, 0, 0.05));
  CHECK(hand.heading.dot(Vec3::UnitZ()) > 0.95);
  draw(hand, up, Vec3(0.03, 0, 0.05), Vec3(0.03, 0, 0.01));
  CHECK(hand.heading.dot(Vec3::UnitZ()) > 0.95);
  lift(hand);
  CHECK(depthOf(hand, up) < 0);
  draw(hand, up, Vec3(0.03, 0, 0.01), Vec3(0.03, 0, -0.1));
  CHECK(hand.heading.dot(Vec3::UnitZ()) < -0.9);
}

TEST_CASE("a hook is pulled towards its handle, and keeps its direction while it holds") {
  const Vec3 up = Vec3::UnitY();
  SurfaceHand hand = takeUp(styleOf("hook"), Vec3::UnitZ());
  pointAt(hand, {Vec3::Zero(), up});
  press(hand);
  CHECK(depthOf(hand, up) == doctest::Approx(hand.depth));
  draw(hand, up, Vec3::Zero(), Vec3(0.03, 0, 0));
  CHECK((poseOf(hand).rotation * Vec3::UnitZ()).x() > 0.5);
  const Vec3 heading = hand.heading;
  draw(hand, up, Vec3(0.03, 0, 0), Vec3(0.03, 0, 0.04));
  CHECK((hand.heading - heading).norm() < 1e-9);
}

TEST_CASE("the depth of an aspirator is that of its groove, below its tip") {
  ToolModel model;
  model.kind = "aspirator";
  for (const double spacing : {0.005, 0.008, 0.012}) {
    SurfaceHand hand = takeUp(handStyleOf(model, spacing), Vec3::UnitX());
    pointAt(hand, {Vec3::Zero(), Vec3::UnitY()});
    press(hand);
    const double reach = std::max(0.0048, 0.6 * spacing);
    CHECK(depthOf(hand, Vec3::UnitY()) == doctest::Approx(hand.depth - reach));
    goDeeper(hand, -1);
    CHECK(depthOf(hand, Vec3::UnitY()) == doctest::Approx(0.0005));  // it still touches
  }
}

TEST_CASE("the wheel presses deeper, within bounds, and turns the edge") {
  const Vec3 up = Vec3::UnitY();
  SurfaceHand hand = takeUp(styleOf("scalpel"), Vec3::UnitX());
  pointAt(hand, {Vec3::Zero(), up});
  press(hand);
  goDeeper(hand, 0.01);
  CHECK(depthOf(hand, up) == doctest::Approx(0.01));  // without a way of the hand
  goDeeper(hand, 1);
  CHECK(hand.depth == hand.style.mostDepth);
  goDeeper(hand, -1);
  CHECK(hand.depth == 0);
  turnHeading(hand, 0.5);
  CHECK(hand.heading.dot(Vec3::UnitX()) == doctest::Approx(std::cos(0.5)));
  CHECK_THROWS_AS(poseOf(takeUp(styleOf("baton"), Vec3::UnitX())), Error);
}

TEST_CASE("a hand that stops bleeding goes to the vessel near the pointer, and works at it") {
  ToolModel clip;
  clip.jaws.opening = 0.5;
  const Vec3 normal = Vec3(0.2, 1, -0.3).normalized(), aside = normal.unitOrthogonal();
  SurfaceHand hand = takeUp(handStyleOf(clip), Vec3::UnitX());
  const Vec3 near = 0.004 * aside - 0.006 * normal, far = 0.03 * aside;
  const std::vector<Vec3> targets = {far, near};
  pointAt(hand, {Vec3::Zero(), normal});
  seek(hand, targets, normal);
  REQUIRE(hand.target);
  CHECK(*hand.target == near);
  CHECK(workPoint(hand) == near);
  CHECK((poseOf(hand).position - (near + (0.006 + hand.style.hover) * normal)).norm() < 1e-12);
  press(hand);
  CHECK((poseOf(hand).position - near).norm() < 1e-12);

  // A hand that presses keeps its vessel, until it is drawn away.
  pointAt(hand, {0.03 * aside, normal});
  seek(hand, targets, normal);
  CHECK_FALSE(hand.target);
  CHECK(depthOf(hand, normal) == doctest::Approx(hand.depth));
  lift(hand);
  seek(hand, targets, normal);
  CHECK(hand.target == far);
  pointAt(hand, {0.1 * aside, normal});
  seek(hand, targets, normal);
  CHECK_FALSE(hand.target);
  CHECK(workPoint(hand) == hand.at.point);
}

TEST_CASE("a swab is pressed on the skin over a vessel, not into the depth to it") {
  ToolModel gauze;
  gauze.kind = "gauze";
  const Vec3 normal = Vec3(0.2, 1, -0.3).normalized();
  SurfaceHand hand = takeUp(handStyleOf(gauze), Vec3::UnitX());
  const std::vector<Vec3> deep = {-0.02 * normal};
  pointAt(hand, {Vec3::Zero(), normal});
  seek(hand, deep, normal);
  CHECK(hand.target == deep[0]);  // its ring shows what is aimed at
  CHECK(workPoint(hand) == hand.at.point);
  CHECK(depthOf(hand, normal) == doctest::Approx(-hand.style.hover));
  press(hand);
  CHECK(depthOf(hand, normal) == doctest::Approx(hand.style.depth));
}

TEST_CASE("a vessel deep under the point that is pointed at is reached along the line of sight") {
  ToolModel clip;
  clip.jaws.opening = 0.5;
  const Vec3 normal = Vec3(-0.3, 1, 0.2).normalized(), eye = Vec3(0.4, 0.8, 0.5).normalized();
  SurfaceHand hand = takeUp(handStyleOf(clip), Vec3::UnitX());
  pointAt(hand, {Vec3(0.01, 0.02, 0.03), normal});
  const Vec3 beside = eye.unitOrthogonal();
  const auto seen = [&](double deep, double aside) {
    const std::vector<Vec3> targets = {hand.at.point - deep * eye + aside * beside};
    seek(hand, targets, eye);
    return hand.target.has_value();
  };
  CHECK(seen(0.03, 0.002));
  CHECK(seen(0.03, 0.015));
  CHECK_FALSE(seen(0.03, 0.02));
  CHECK_FALSE(seen(0.08, 0.002));
}

TEST_CASE("on a steep flank a long instrument reaches its vessel, its handle above the table") {
  ToolModel clip;
  clip.jaws.opening = 0.5;
  for (const double flank : {0.0, 0.6, 1.2, 1.5}) {  // rad
    for (const double round : {0.0, 2.0, 4.0}) {
      CAPTURE(flank);
      CAPTURE(round);
      const Vec3 normal(std::sin(flank) * std::cos(round), std::cos(flank),
                        std::sin(flank) * std::sin(round));
      SurfaceHand hand = takeUp(handStyleOf(clip), -normal.unitOrthogonal());
      pointAt(hand, {Vec3(0, 0.05, 0), normal});
      const std::vector<Vec3> targets = {Vec3(0.002, 0.04, -0.003)};
      seek(hand, targets, normal);
      REQUIRE(hand.target);
      press(hand);
      const std::vector<Vec3> ends = {Vec3::Zero(), Vec3(0, 0, 0.25)};  // tip and handle
      const Pose pose = poseAboveTable(hand, ends);
      CHECK((pose.position - targets[0]).norm() < 1e-9);
      CHECK((pose * ends[1]).y() > 0.1);
    }
  }
}

TEST_CASE("an instrument that stops no bleeding seeks nothing") {
  const std::vector<Vec3> targets = {Vec3(0.001, 0, 0)};
  for (const char* name : {"scalpel", "hook", "baton", "scissors", "forceps"}) {
    SurfaceHand hand = takeUp(styleOf(name), Vec3::UnitX());
    pointAt(hand, {Vec3::Zero(), Vec3::UnitY()});
    seek(hand, targets, Vec3::UnitY());
    CHECK_FALSE(hand.target);
  }
}
