#include "haptics/force_renderer.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace resect {
namespace {

// A slow simulation: the difference fades over at most this many durations of a frame.
constexpr double kMostFrames = 4;

// A point of the instrument, which was at `place` in the simulation, in the hand.
struct Lever {
  Vec3 place;       // where it is now
  Vec3 way, speed;  // how far and how fast beyond the simulated instrument
};
Lever leverAt(const LocalModel& model, const HandState& hand, const Vec3& place) {
  const Vec3 now = hand.pose * (model.pose.inverse() * place);
  const Vec3 speed = hand.velocity + hand.spin.cross(now - hand.pose.position);
  const Vec3 before = model.velocity + model.spin.cross(place - model.pose.position);
  return {now, now - place, speed - before};
}

Vec3 shortened(const Vec3& v, double most) {
  const double length = v.norm();
  return length > most ? Vec3(most / length * v) : v;
}

}  // namespace

Wrench forceAt(const LocalModel& model, const HandState& hand) {
  Wrench sum;
  if (!model.inHand) return sum;
  const auto add = [&](const Vec3& place, const Vec3& force) {
    sum.force += force;
    sum.torque += (place - hand.pose.position).cross(force);
  };
  double normalForce = 0;
  Mat3 normals = Mat3::Zero();
  for (int k = 0; k < model.planeCount; ++k) {
    const ContactPlane& plane = model.planes[std::size_t(k)];
    const Lever lever = leverAt(model, hand, plane.place);
    const double force = plane.force - plane.stiffness * lever.way.dot(plane.normal) -
                         plane.damping * lever.speed.dot(plane.normal);
    if (!(force > 0)) continue;
    add(lever.place, force * plane.normal);
    normalForce += force;
    normals += force * plane.normal * plane.normal.transpose();
  }
  const Lever lever = leverAt(model, hand, model.restPlace);
  const Vec3 change = model.restStiffness * lever.way;
  if (model.held || model.planeCount == 0)
    add(lever.place, model.rest - change);
  else if (normalForce > 0)
    add(lever.place, shortened(model.rest - (change - normals * change / normalForce),
                               model.friction * normalForce));
  return sum;
}

ForceRenderer::ForceRenderer(double mostForce) : mostForce_(mostForce) {
  require(mostForce > 0, "the largest force is {} N; give more than 0", mostForce);
}

void ForceRenderer::take(const LocalModel& model, const HandState& hand, double now) {
  const Wrench before = render(hand, now), expected = forceAt(model_, hand);
  const double since = now - taken_;
  model_ = model;
  const Wrench after = forceAt(model_, hand);
  fading_ = {before.force - after.force, before.torque - after.torque};
  correction_ = (after.force - expected.force).norm();
  taken_ = now;
  fadeTime_ = std::clamp(since, model.duration, kMostFrames * model.duration);
}

Wrench ForceRenderer::render(const HandState& hand, double now) const {
  Wrench wrench = forceAt(model_, hand);
  const double left = fadeTime_ > 0 ? std::clamp(1 - (now - taken_) / fadeTime_, 0.0, 1.0) : 0;
  wrench.force += left * fading_.force;
  wrench.torque += left * fading_.torque;
  if (const double force = wrench.force.norm(); force > mostForce_) {
    wrench.force *= mostForce_ / force;
    wrench.torque *= mostForce_ / force;
  }
  return wrench;
}

}  // namespace resect
