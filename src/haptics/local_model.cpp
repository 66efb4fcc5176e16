#include "haptics/local_model.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "haptics/local_stiffness.h"

namespace resect {
namespace {

constexpr double kSamePlane = 0.82;  // cosine of 35 degrees: points of one plane

// Sums over the points of a plane, weighted by their forces.
struct PlaneSum {
  Vec3 seed = Vec3::Zero();  // normal of its first point
  Vec3 normal = Vec3::Zero(), place = Vec3::Zero();
  double force = 0, stiffness = 0, damping = 0;
};

// The plane that a point with that normal belongs to. A new one is opened while there is room.
PlaneSum& planeOf(const Vec3& normal, std::array<PlaneSum, kMostPlanes>& planes, int& count) {
  int best = -1;
  double nearest = -2;
  for (int k = 0; k < count; ++k)
    if (const double cosine = planes[std::size_t(k)].seed.dot(normal); cosine > nearest)
      best = k, nearest = cosine;
  if (nearest < kSamePlane && count < kMostPlanes) {
    best = count++;
    planes[std::size_t(best)].seed = normal;
  }
  return planes[std::size_t(best)];
}

LocalModuli meanModuli(const TissueTouch& touch, double time) {
  LocalModuli mean;
  double weights = 0;
  const auto add = [&](const TissueMaterial& material, double weight) {
    const LocalModuli m = moduliWithin(material, time);
    mean.shear += weight * m.shear;
    mean.poisson += weight * m.poisson;
    mean.plane += weight * m.plane;
    weights += weight;
  };
  // Most contacts lie on one material, whose moduli are found once.
  const TissueMaterial* last = nullptr;
  double gathered = 0;
  const auto gather = [&](const TissueMaterial* material, double weight) {
    if (last && material != last) add(*last, gathered), gathered = 0;
    last = material;
    gathered += weight;
  };
  for (const PressedPoint& point : touch.pressed) gather(point.material, point.area);
  if (touch.pressed.empty())
    for (const HeldPoint& point : touch.held) gather(point.material, 1);
  if (last) add(*last, gathered);
  if (!(weights > 0)) return {};
  return {mean.shear / weights, mean.poisson / weights, mean.plane / weights};
}

double squared(double x) { return x * x; }

}  // namespace

LocalModel makeLocalModel(const InstrumentFrame& frame, std::span<const TissueTouch> touches) {
  require(frame.duration > 0, "the frame lasts {} s; give a time above 0", frame.duration);
  LocalModel model;
  model.duration = frame.duration;
  model.inHand = true;
  model.pose = frame.to;
  model.velocity = (frame.to.position - frame.from.position) / frame.duration;
  model.spin = rotationVector(frame.to.rotation * frame.from.rotation.conjugate()) / frame.duration;
  model.friction = frame.friction;

  std::array<PlaneSum, kMostPlanes> sums;
  int count = 0;
  double anchors = 0;
  for (const TissueTouch& touch : touches) {
    const LocalModuli moduli = meanModuli(touch, frame.duration);
    double area = 0, springs = 0;
    for (const PressedPoint& point : touch.pressed) area += point.area, springs += point.stiffness;
    const double below = area > 0 ? pressedStiffness(moduli, area, touch.spacing) : 0;
    // The springs of the points, one beside the other, and then the tissue below them.
    const double share = springs > 0 ? below / (springs + below) : 0;
    for (const PressedPoint& point : touch.pressed) {
      PlaneSum& plane = planeOf(-point.outwards, sums, count);
      plane.normal -= point.force * point.outwards;
      plane.place += point.force * point.place;
      plane.force += point.force;
      plane.stiffness += share * point.stiffness;
      plane.damping += squared(share) * point.damping;
    }
    if (area > 0) model.restStiffness += draggedStiffness(moduli, area, touch.spacing);
    if (touch.held.empty()) continue;
    double grips = 0;
    for (const HeldPoint& point : touch.held) {
      grips += point.stiffness;
      model.restPlace += point.stiffness * point.place;
    }
    const double around = heldStiffness(moduli, int(touch.held.size()), touch.spacing);
    model.restStiffness += inSeries(grips, around);
    model.held = true;
    anchors += grips;
  }

  Vec3 pressed = Vec3::Zero(), middle = Vec3::Zero();
  double normalForce = 0;
  for (int k = 0; k < count; ++k) {
    const PlaneSum& sum = sums[std::size_t(k)];
    const double length = sum.normal.norm();
    if (!(sum.force > 0 && length > 0)) continue;
    ContactPlane& plane = model.planes[std::size_t(model.planeCount++)];
    plane = {sum.place / sum.force, sum.normal / length, sum.force, sum.stiffness, sum.damping};
    model.stiffness += plane.stiffness * plane.normal * plane.normal.transpose();
    pressed += plane.force * plane.normal;
    middle += plane.force * plane.place;
    normalForce += plane.force;
  }
  if (model.held) {
    model.restPlace /= anchors;
    model.stiffness += model.restStiffness * Mat3::Identity();
  } else if (model.planeCount > 0) {
    model.restPlace = middle / normalForce;
    Mat3 normals = Mat3::Zero();
    for (int k = 0; k < model.planeCount; ++k) {
      const ContactPlane& plane = model.planes[std::size_t(k)];
      normals += plane.force / normalForce * plane.normal * plane.normal.transpose();
    }
    model.stiffness += model.restStiffness * (Mat3::Identity() - normals);
  } else {
    model.restPlace = frame.to.position;
  }

  // The mean force belongs to the middle of the frame; half a frame later the instrument is deeper.
  const Vec3 ahead = 0.5 * (frame.to.position - frame.from.position);
  model.force = frame.force - model.stiffness * ahead;
  // The planes' springs give the force but for what damping adds. They are scaled to it.
  if (!model.held && pressed.squaredNorm() > 0) {
    const double scale = std::clamp(model.force.dot(pressed) / pressed.squaredNorm(), 0.0, 2.0);
    for (int k = 0; k < model.planeCount; ++k) model.planes[std::size_t(k)].force *= scale;
    pressed *= scale;
  }
  model.rest = model.force - pressed;
  const auto turns = [&](const Vec3& place, const Vec3& force) {
    model.torque += (place - model.pose.position).cross(force);
  };
  for (int k = 0; k < model.planeCount; ++k)
    turns(model.planes[std::size_t(k)].place,
          model.planes[std::size_t(k)].force * model.planes[std::size_t(k)].normal);
  turns(model.restPlace, model.rest);
  return model;
}

LocalModel LocalModels::make(const Simulation& simulation, std::size_t tool, double duration) {
  require(tool < simulation.tools().size(), "there is no tool {} among {}; number from 0", tool,
          simulation.tools().size());
  require(duration > 0, "the frame lasts {} s; give a time above 0", duration);
  const ToolState& state = simulation.tools()[tool];
  LocalModel model;
  if (state.inHand) {
    touches_.resize(simulation.organs().size());
    for (std::size_t o = 0; o < touches_.size(); ++o)
      simulation.organs()[o].tissue->touchOf(std::int32_t(tool), touches_[o]);
    model = makeLocalModel(
        {state.way.from.pose, state.way.to.pose, duration, state.force, state.tool->model.friction},
        touches_);
  }
  model.frame = simulation.frame() - 1;
  model.time = simulation.time();
  model.duration = duration;
  model.pose = state.way.to.pose;
  return model;
}

}  // namespace resect
