// What the window says about vessels that clips and forceps have closed.
#include "app/advice/haemostasis_watch.h"

#include <doctest/doctest.h>

using namespace resect;

namespace {

BleedingEnd vein(double flow) {
  return {0, 7, VesselEnd::Root, Vec3(0.001, 0.002, 0), flow, 0.0015};
}

// The state at a time: forceps or clip applier with its tip at the origin.
LiveState stateAt(double time, double squeeze, std::vector<BleedingEnd> ends, int clips = 0) {
  LiveState state;
  state.time = time;
  state.poses = {Pose()};
  state.squeeze = {squeeze};
  state.bleedingEnds = std::move(ends);
  state.clips.assign(std::size_t(clips), {0, 3, 0.0015});
  state.bleeds = true;
  return state;
}

ToolModel modelOf(const char* kind) {
  ToolModel model;
  model.kind = kind;
  return model;
}

// Somebody with an instrument of this kind in hand; or a scenario that moves it.
struct Hand {
  HaemostasisWatch watch;
  HaemostasisWatch::Worker worker = HaemostasisWatch::Worker::Hand;

  explicit Hand(const char* kind) : watch(0, modelOf(kind)) {}
  std::string said(const LiveState& state) {
    const auto name = [](std::int32_t, std::int32_t) { return std::string("left hepatic vein"); };
    return watch.follow(state, worker, name).toStdString();
  }
};

}  // namespace

TEST_CASE("forceps that have sealed a vessel say which, once, while they are still closed") {
  Hand hand("bipolar");
  const BleedingEnd far{0, 8, VesselEnd::Root, Vec3(0.1, 0, 0), 1e-6, 0.002};
  CHECK(hand.said(stateAt(0, 0, {vein(1e-6), far})).empty());
  CHECK(hand.said(stateAt(0.1, 1, {vein(1e-6), far})).empty());
  CHECK(hand.watch.howLongClosed(stateAt(1.6, 1, {})).contains("1.6 s"));
  CHECK(hand.said(stateAt(1.6, 1, {vein(0.5e-6), far})).empty());
  // The far one stops by itself, which is not the forceps' work.
  CHECK(hand.said(stateAt(2, 1, {})) == "Sealed: the left hepatic vein of 3.0 mm bled 60 ml/min");
  CHECK(hand.said(stateAt(2.1, 1, {})).empty());
}

TEST_CASE("a clip names the vessel whose bleeding it has reduced most, though some is left") {
  Hand hand("clip_applier");
  const BleedingEnd thin{0, 8, VesselEnd::Root, Vec3(0.002, 0, 0), 0.1e-6, 0.0005};
  CHECK(hand.said(stateAt(0, 0, {vein(1e-6), thin})).empty());
  CHECK(hand.said(stateAt(0.1, 1, {vein(1e-6), thin}, 1)).empty());
  CHECK(hand.said(stateAt(0.5, 1, {vein(0.3e-6)}, 1)) ==
        "A clip was placed: the left hepatic vein of 3.0 mm bled 60 ml/min, and 18 now");
}

TEST_CASE("a click that is too short for the jaws is told") {
  Hand hand("clip_applier");
  // As an instrument is taken its jaws open.
  double time = 0;
  const auto said = [&](double squeeze) { return hand.said(stateAt(time += 0.1, squeeze, {})); };
  for (const double squeeze : {1.0, 0.5, 0.2, 0.0, 0.0}) CHECK(said(squeeze).empty());
  for (const double squeeze : {0.1, 0.2, 0.1}) CHECK(said(squeeze).empty());
  CHECK(said(0).find("The jaws did not close") == 0);
  CHECK(said(0).empty());
  // They close, and open again.
  for (const double squeeze : {0.3, 0.7}) CHECK(said(squeeze).empty());
  CHECK(said(1).find("No clip was placed") == 0);
  for (const double squeeze : {1.0, 0.6, 0.2, 0.0, 0.0}) CHECK(said(squeeze).empty());
}

TEST_CASE("jaws that open when the time begins to run are no short click") {
  Hand hand("clip_applier");
  for (int i = 0; i < 3; ++i) CHECK(hand.said(LiveState()).empty());  // no frame yet
  for (const double squeeze : {0.6, 0.2, 0.0}) CHECK(hand.said(stateAt(0.1, squeeze, {})).empty());
}

TEST_CASE("a clip says what it has closed when the flow is steady, or that it found nothing") {
  Hand hand("clip_applier");
  CHECK(hand.said(stateAt(0, 0, {vein(1e-6)})).empty());
  CHECK(hand.said(stateAt(0.1, 1, {vein(1e-6)}, 1)).empty());
  // The jaws may be open again by then.
  CHECK(hand.said(stateAt(0.2, 0, {}, 1)).empty());
  CHECK(hand.said(stateAt(0.5, 0, {}, 1)) ==
        "A clip was placed: the left hepatic vein of 3.0 mm bled 60 ml/min");
  CHECK(hand.said(stateAt(1, 0, {}, 1)).empty());
  CHECK(hand.said(stateAt(1.1, 1, {}, 1)).find("No clip was placed") == 0);
  CHECK_FALSE(HaemostasisWatch::watches(modelOf("hook")));
  CHECK(hand.said(stateAt(1.2, 0, {}, 1)).empty());
  LiveState without = stateAt(1.3, 1, {}, 1);
  without.bleeds = false;
  CHECK(hand.said(without) == "No clip was placed: this organ has no vessels");
}

TEST_CASE("clips of a scenario that plays are told, but not what a hand could do better") {
  Hand hand("clip_applier");
  hand.worker = HaemostasisWatch::Worker::Scenario;
  CHECK(hand.said(stateAt(0, 0, {vein(1e-6)})).empty());
  CHECK(hand.said(stateAt(0.1, 1, {vein(1e-6)}, 1)).empty());
  CHECK(hand.said(stateAt(0.5, 0, {}, 1)).find("A clip was placed: the left hepatic vein") == 0);
  CHECK(hand.said(stateAt(0.6, 0.5, {}, 1)).empty());
  CHECK(hand.said(stateAt(0.7, 0, {}, 1)).empty());
  CHECK(hand.said(stateAt(0.8, 1, {}, 1)).empty());
  // Put back, with closed jaws.
  hand.worker = HaemostasisWatch::Worker::Nobody;
  CHECK(hand.said(stateAt(0.9, 1, {vein(1e-6)}, 1)).empty());
  hand.worker = HaemostasisWatch::Worker::Hand;
  CHECK(hand.said(stateAt(1, 1, {vein(1e-6)}, 1)).empty());
}
