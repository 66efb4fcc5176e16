#include "operation/hand/surface_hand.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "base/error.h"
#include "geometry/rotation.h"
#include "tools/parts/aspirator_part.h"

namespace resect {
namespace {

constexpr double kUpWay = 0.015;     // m of way over which the normal is averaged
constexpr double kDescent = 2.7;     // m of depth per m of way, of such an edge
constexpr double kStart = 0.002;     // m of way that show the direction of a stroke; then it enters
constexpr double kStraight = 0.006;  // m of way in which a stroke may still choose its direction
constexpr double kStill = 1e-6;      // m
constexpr double kSeeks = 0.018;     // m: a hand that stops bleeding finds a vessel this near

// A unit vector at right angles to `up`, as near to `wanted` as possible.
Vec3 alongSurface(const Vec3& wanted, const Vec3& up) {
  const Vec3 flat = wanted - wanted.dot(up) * up;
  constexpr double kSmall = 1e-3;
  return flat.norm() > kSmall ? Vec3(flat.normalized()) : up.unitOrthogonal();
}

// Turns the heading towards a way of the hand, by a share that grows with its length.
void follow(SurfaceHand& hand, const Vec3& way, double turnWay) {
  const double length = way.norm();
  if (turnWay <= 0 || length < kStill) return;
  // Back along its way a blade is withdrawn; it does not turn round in the tissue.
  constexpr double kBack = -0.2;
  if (hand.pressing && way.dot(hand.heading) < kBack * length) return;
  Vec3 sum = math::exp(-length / turnWay) * hand.heading +
             (1 - math::exp(-length / turnWay)) * way / length;
  constexpr double kOpposite = 0.05;
  if (sum.norm() < kOpposite) sum += kOpposite * hand.up.cross(hand.heading);
  hand.heading = sum;
}

}  // namespace

HandStyle handStyleOf(const ToolModel& tool, double spacing) {
  HandStyle style;
  if (tool.kind == "inflow_clamp") {
    style = {.upright = 0.6, .forward = -0.8, .hover = 0.012, .depth = 0.004};
    style.turnHovering = 0.06;
    style.closesJaws = true;
  } else if (tool.kind == "gauze") {
    style = {.upright = 0.8, .forward = -0.6, .hover = 0.012, .depth = 0.005};
    style.seeks = kSeeks;
    style.staysOutside = true;
  } else if (tool.kind == "aspirator") {
    style = {.upright = 0.8, .forward = -0.6, .hover = 0.006, .depth = 0.008};
    style.mostDepth = 0.02;
    style.reach = aspiratorReach(spacing);
    constexpr double kIn = 0.0005;  // m: its tip must touch tissue
    style.leastDepth = style.reach + kIn;
    style.depth = std::max(style.depth, style.leastDepth);
  } else if (tool.kind == "forceps") {
    style = {.upright = 0.8, .forward = -0.6, .hover = 0.008, .depth = 0.002};
    style.closesJaws = true;
  } else if (tool.jaws.opening > 0 && tool.edge.empty()) {
    // Clips and forceps reach into a wound of a scalpel's depth.
    style = {.upright = 0.8, .forward = -0.6, .hover = 0.010, .depth = 0.012};
    style.turnHovering = 0.06;
    style.closesJaws = true;
    style.seeks = kSeeks;
  } else if (tool.kind == "suction") {
    style = {.upright = 0.8, .forward = -0.6, .hover = 0.008, .depth = 0};
    style.seeks = kSeeks;
  } else if (tool.jaws.opening > 0) {
    // One jaw below the surface and one above.
    style = {.upright = 0.42, .forward = -0.91, .hover = 0.014, .depth = 0.008};
    style.turnHovering = 0.06;
    style.closesJaws = true;
  } else if (tool.edge.size() > 1) {
    style = {.upright = 0.8, .forward = 0.6, .hover = 0.005, .depth = 0.016};
    if (tool.kind == "pencil") style.depth = 0.008;
    double reach = 0;  // of the edge along the handle
    for (const Vec3& p : tool.edge) reach = std::max(reach, (p - tool.edge.front()).dot(tool.axis));
    constexpr double kOut = 0.004;  // m
    style.mostDepth = std::clamp(style.upright * reach - kOut, style.depth, style.mostDepth);
    constexpr double kParts = 0.5;  // cells
    if (tool.kind != "pencil") style.leastDepth = std::min(kParts * spacing, style.mostDepth);
    style.depth = std::max(style.depth, style.leastDepth);
    style.turnHovering = 0.02;
    style.turnPressing = 0.012;
    style.entersSlowly = style.headsForWay = true;
  } else if (!tool.hook.empty()) {
    style = {.upright = 0.6, .forward = 0.8, .hover = 0.006, .depth = 0.012};
    style.headsForWay = true;
  } else {
    style = {.upright = 0.9, .forward = 0.44, .hover = 0.005, .depth = 0.008};
  }
  return style;
}

SurfaceHand takeUp(const HandStyle& style, const Vec3& heading) {
  SurfaceHand hand;
  hand.style = style;
  hand.depth = style.depth;
  hand.heading = alongSurface(heading, hand.up);
  return hand;
}

void pointAt(SurfaceHand& hand, const SurfacePoint& at) {
  const Vec3 way = hand.pointing ? Vec3(at.point - hand.at.point) : Vec3::Zero();
  if (!hand.pointing) hand.up = at.normal;
  hand.pointing = true;
  hand.at = at;
  const double length = way.norm();
  hand.up = (hand.up + (1 - math::exp(-length / kUpWay)) * (at.normal - hand.up)).normalized();
  const double before = hand.way;  // a quick hand passes kStraight at once
  if (hand.pressing) hand.way += length, hand.stroke += length;
  const Vec3 flat = way - way.dot(hand.up) * hand.up;
  const bool starts = hand.pressing && hand.style.headsForWay && before < kStraight;
  if (starts && flat.norm() > kStill) {
    // The first millimetres decide, those after them correct.
    const double share = before < kStart ? 1 : 0.5;
    hand.heading += share * (flat.normalized() - hand.heading);
  } else {
    follow(hand, flat, hand.pressing ? hand.style.turnPressing : hand.style.turnHovering);
  }
  hand.heading = alongSurface(hand.heading, hand.up);
}

void landAt(SurfaceHand& hand, const SurfacePoint& at) {
  hand.pointing = true;
  hand.at = at;
  hand.up = at.normal;
  hand.way = hand.stroke = 0;
  hand.heading = alongSurface(hand.heading, hand.up);
}

void press(SurfaceHand& hand) {
  hand.pressing = true;
  hand.way = hand.stroke = 0;
}

void lift(SurfaceHand& hand) { hand.pressing = false; }

void seek(SurfaceHand& hand, std::span<const Vec3> targets, const Vec3& towardsEye) {
  if (!hand.pointing) return;
  // How far beside the target the hand points, as it is seen. A vessel may lie deep in the tissue.
  const auto beside = [&](const Vec3& target) {
    const Vec3 way = target - hand.at.point;
    const double along = way.dot(towardsEye);
    return std::abs(along) < hand.style.mostDepth ? (way - along * towardsEye).norm() : HUGE_VAL;
  };
  if (hand.pressing) {
    if (hand.target && !(beside(*hand.target) < hand.style.seeks)) hand.target.reset();
    return;
  }
  hand.target.reset();
  double least = hand.style.seeks;
  for (const Vec3& target : targets)
    if (const double distance = beside(target); distance < least)
      least = distance, hand.target = target;
}

Vec3 workPoint(const SurfaceHand& hand) {
  return hand.target && !hand.style.staysOutside ? *hand.target : hand.at.point;
}

void goDeeper(SurfaceHand& hand, double more) {
  hand.depth = std::clamp(hand.depth + more, hand.style.leastDepth, hand.style.mostDepth);
  if (hand.pressing) hand.way = std::max(hand.way, kStart) + std::max(0.0, more) / kDescent;
}

void turnHeading(SurfaceHand& hand, double angle) {
  hand.heading = rotationAbout(hand.up, angle) * hand.heading;
}

namespace {

// The direction in which the instrument goes in, of a length that gains 1 m of depth. A blade goes
// in along its handle, so that it enters where the hand points.
Vec3 wayIn(const SurfaceHand& hand, const Vec3& handle) {
  return hand.pressing && hand.style.entersSlowly ? Vec3(-handle / handle.dot(hand.up))
                                                  : Vec3(-hand.up);
}

// The direction of a handle, turned up so far that a hand can hold it: on a steep flank it would
// point below the horizon, and a long instrument into the table.
Vec3 raised(const Vec3& handle) {
  constexpr double kLeastUp = 0.4;  // 24 degrees above the horizon
  if (handle.y() >= kLeastUp) return handle;
  const Vec3 flat(handle.x(), 0, handle.z());
  constexpr double kSmall = 1e-3;
  if (flat.norm() < kSmall) return Vec3(0, 1, 0);
  return std::sqrt(1 - kLeastUp * kLeastUp) * flat.normalized() + Vec3(0, kLeastUp, 0);
}

}  // namespace

Pose poseOf(const SurfaceHand& hand) {
  require(hand.pointing, "the hand points at nothing; point at a surface first");
  const HandStyle& style = hand.style;
  Vec3 handle = (style.upright * hand.up + style.forward * hand.heading).normalized();
  Vec3 edge = (style.upright * hand.heading - style.forward * hand.up).normalized();
  if (!style.entersSlowly) {  // a blade keeps its angle to the surface
    handle = raised(handle);
    edge = alongSurface(edge, handle);
  }
  Mat3 axes;  // the tool's edge faces its -y, its handle its +z
  axes << -edge.cross(handle), -edge, handle;
  double depth = -style.hover;
  const bool goesTo = hand.target && !style.staysOutside;
  // Hovering over the surface above the target.
  if (!hand.pressing && goesTo) depth -= std::max(0.0, (hand.at.point - *hand.target).dot(hand.up));
  if (hand.pressing && goesTo)
    depth = 0;
  else if (hand.pressing)
    depth =
        (style.entersSlowly ? std::min(hand.depth, kDescent * (hand.way - kStart)) : hand.depth) -
        style.reach;
  return {workPoint(hand) + depth * wayIn(hand, handle), Eigen::Quaterniond(axes)};
}

Pose poseAboveTable(const SurfaceHand& hand, std::span<const Vec3> points) {
  const Pose pose = poseOf(hand);
  double lowest = 0;
  for (const Vec3& p : points) lowest = std::min(lowest, (pose * p).y());
  if (!(lowest < 0)) return pose;
  const Vec3 in = wayIn(hand, pose.rotation * Vec3::UnitZ());
  constexpr double kLevel = -0.2;  // a way in that hardly leads down is left straight up
  const Vec3 out = in.y() < kLevel ? Vec3(lowest / in.y() * -in) : Vec3(0, -lowest, 0);
  return {pose.position + out, pose.rotation};
}

}  // namespace resect
