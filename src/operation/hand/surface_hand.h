// A hand that guides an instrument over an organ by pointing at the organ's surface.
//
// While the hand hovers, the instrument's tip is above the point at which the hand points. While it
// presses, the tip is below that point by `depth`. An instrument with an edge enters along its way,
// so that a stroke begins shallow. The instrument leans against the surface as its kind is held,
// and turns towards the motion of the hand: a blade cuts towards where it goes.
#pragma once

#include <optional>
#include <span>

#include "geometry/pose.h"
#include "geometry/ray.h"
#include "tools/tool.h"

namespace resect {

// How an instrument of some kind is held over a surface.
struct HandStyle {
  // The direction to the handle is `upright` times the normal plus `forward` times the heading.
  double upright = 1, forward = 0;
  double hover = 0.005;     // m: height of the tip over the surface while hovering
  double depth = 0.01;      // m: of the tip below the surface while pressing, at first
  double mostDepth = 0.06;  // m: a blade whose edge does not reach out of the tissue makes a tunnel
  double turnHovering = 0;  // m of way in which the heading follows the hand; 0: it does not turn
  double turnPressing = 0;  // the same while pressing
  bool entersSlowly = false;  // the tip goes down no farther than it goes on
  bool headsForWay = false;   // the first millimetres of a stroke set the heading
  bool closesJaws = false;    // pressing closes the jaws
  double seeks = 0;           // m: how far beside a target the hand may point (seek())
  bool staysOutside = false;  // presses on the surface over a target, and does not go to it
};
// By the model's kind or else its geometry: a blade has an edge, scissors have jaws, a hook has a
// bend.
HandStyle handStyleOf(const ToolModel& tool);

struct SurfaceHand {
  HandStyle style;
  double depth = 0.01;           // m, 0 to style.mostDepth
  SurfacePoint at;               // at which the hand points
  Vec3 up = Vec3::UnitY();       // unit: the normal, averaged over the way
  Vec3 heading = Vec3::UnitZ();  // unit, at right angles to `up`: the edge faces this way
  bool pointing = false;         // `at` is set
  bool pressing = false;
  double way = 0;              // m: of the hand since it began to press
  std::optional<Vec3> target;  // at which the tip works instead of below `at`, world, m
};

// Takes up an instrument. heading: unit; for blades the direction of the cut.
SurfaceHand takeUp(const HandStyle& style, const Vec3& heading);
void pointAt(SurfaceHand& hand, const SurfacePoint& at);
void press(SurfaceHand& hand);
void lift(SurfaceHand& hand);
// Changes the depth by `more`, m; at once if the hand presses.
void goDeeper(SurfaceHand& hand, double more);
// Turns the heading about the normal, anticlockwise as seen from outside, rad.
void turnHeading(SurfaceHand& hand, double angle);

// Chooses the target that is seen nearest to the point at which the hand points, if it is seen
// within style.seeks of it and lies at most style.mostDepth behind or before it. towardsEye: unit,
// from that point. A hand that presses keeps its target while that holds, and takes up no other.
void seek(SurfaceHand& hand, std::span<const Vec3> targets, const Vec3& towardsEye);
// The point at which the instrument works: the target, unless it stays outside, or else the point
// on the surface.
Vec3 workPoint(const SurfaceHand& hand);

// Where the hand has the instrument: the pose of the tool's frame, whose origin is the tip. The
// hand must be pointing.
Pose poseOf(const SurfaceHand& hand);
// The same, drawn back the way it went in until none of `points`, in the tool's frame, m, lies
// below y = 0, the top of the table.
Pose poseAboveTable(const SurfaceHand& hand, std::span<const Vec3> points);

}  // namespace resect
