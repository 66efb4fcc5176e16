// A hand that guides an instrument over an organ by pointing at the organ's surface, as a user does
// with the mouse.
//
// While the hand hovers, the instrument's tip is above the point at which the hand points. While
// the hand presses, the tip is below that point by `depth`. An instrument with a cutting edge
// reaches this depth gradually while the hand moves along the surface, so that a stroke begins
// shallow. The angle between instrument and surface depends on the kind of instrument. The
// instrument turns towards the motion of the hand, so that a blade cuts in the direction of the
// motion.
#pragma once

#include <optional>
#include <span>

#include "geometry/pose.h"
#include "geometry/ray.h"
#include "tools/tool.h"

namespace resect {

// How an instrument of some kind is held over a surface.
struct HandStyle {
  // The direction to the instrument's handle is `upright` times the surface's normal plus `forward`
  // times SurfaceHand::heading.
  double upright = 1, forward = 0;
  double hover = 0.005;     // m: height of the tip over the surface while hovering
  double depth = 0.01;      // m: depth to which the hand presses, unless goDeeper() changes it
  double mostDepth = 0.06;  // m: greatest depth; a blade that is deeper would cut a tunnel
  double leastDepth = 0;    // m: smallest depth; a shallower stroke would slide over the skin
  // m: how far beyond its tip the instrument takes tissue. Depths are those to which it takes it.
  double reach = 0;
  // m: length of motion in which 63 % of the angle between heading and motion disappears; 0: the
  // heading never turns. turnHovering: while hovering; turnPressing: while pressing.
  double turnHovering = 0;
  double turnPressing = 0;
  bool entersSlowly = false;  // the depth is reached gradually, by motion along the surface
  bool headsForWay = false;   // the first 6 mm of a stroke set the heading
  bool closesJaws = false;    // pressing closes the jaws
  double seeks = 0;           // m: greatest distance of a target (see seek())
  bool staysOutside = false;  // the tip works at the surface even if there is a target
};
// The style for an instrument. Some kinds of instrument have a style of their own. For the other
// kinds, the geometry decides: a blade has an edge, scissors have jaws, a hook has a bend. spacing:
// side of the tissue's cells, m. A scalpel goes at least half a cell deep, since a shallower stroke
// would part the skin only here and there.
HandStyle handStyleOf(const ToolModel& tool, double spacing = 0);

struct SurfaceHand {
  HandStyle style;
  double depth = 0.01;           // m, 0 to style.mostDepth
  SurfacePoint at;               // the point at which the hand points
  Vec3 up = Vec3::UnitY();       // unit: the surface's normal, averaged over about 15 mm of path
  Vec3 heading = Vec3::UnitZ();  // unit, at right angles to `up`: the edge faces this way
  bool pointing = false;         // `at` is set
  bool pressing = false;
  double way = 0;              // m: of its path since it began to press; goDeeper() may add
  double stroke = 0;           // m: length of its path while it presses, or pressed last
  std::optional<Vec3> target;  // point at which the tip works instead of at `at`, world, m
};

// A hand that has taken up an instrument. heading: unit; for blades, the direction of the cut.
SurfaceHand takeUp(const HandStyle& style, const Vec3& heading);
void pointAt(SurfaceHand& hand, const SurfacePoint& at);
// Does the same as pointAt(), but the way to `at` is not part of the hand's path: the path begins
// at `at`. The heading changes only as much as the surface there requires.
void landAt(SurfaceHand& hand, const SurfacePoint& at);
void press(SurfaceHand& hand);
void lift(SurfaceHand& hand);
// Changes the depth by `more`, m. If the hand presses, the tip follows at once, even if
// style.entersSlowly is true.
void goDeeper(SurfaceHand& hand, double more);
// Turns the heading about the normal by `angle`, rad, anticlockwise as seen from outside.
void turnHeading(SurfaceHand& hand, double angle);

// Targets are places such as the ends of cut vessels, at which the tip can work instead of at the
// surface. Chooses the target that, as the eye sees it, is nearest to the point at which the hand
// points. Two conditions must be met. At right angles to the line of sight, the distance between
// target and point must be less than style.seeks. Along the line of sight, this distance must be
// less than style.mostDepth. While the hand presses, it takes no new target, and it keeps its old
// target as long as this target meets the conditions. targets: world, m. towardsEye: direction from
// the hand's point to the eye, unit.
void seek(SurfaceHand& hand, std::span<const Vec3> targets, const Vec3& towardsEye);
// The point at which the instrument works, world, m. This is the target, if there is one and
// style.staysOutside is false. Otherwise it is the point at which the hand points.
Vec3 workPoint(const SurfaceHand& hand);

// The pose of the tool's frame in the world. The origin of this frame is the tool's tip. The hand
// must be pointing.
Pose poseOf(const SurfaceHand& hand);
// The pose of poseOf(), but with the instrument drawn back far enough that none of its `points`
// lies below the top of the table (y = 0). It is drawn back in the direction from which it enters.
// points: in the tool's frame, m.
Pose poseAboveTable(const SurfaceHand& hand, std::span<const Vec3> points);

}  // namespace resect
