// Draws the guidance of a task into the scene. A task is an exercise with a goal, and lines mark
// the places of this goal. The colour of the lines shows how well the instrument in hand keeps to
// the goal. The lines are visible through tissue, too.
#pragma once

#include <optional>
#include <vector>

#include "inventor/hand/marks/line_marks.h"

namespace resect {

struct Guide {
  enum class Kind {
    // The tip should come within `radius` of places[next].
    Targets,
    // The instrument should stay within `radius` of the polyline through `places`, in their order.
    Line,
    // The tip should stay within `radius` of the plane through places[0] with the normal `normal`.
    Plane,
    // The tip should stay `margin` away from a structure. The structure is approximated by a ball
    // with the radius `radius` round places[0].
    Ball
  };
  Kind kind = Kind::Targets;
  std::vector<Vec3> places;     // world, m
  std::size_t next = 0;         // index in `places` of the next target
  double radius = 0.006;        // m, see Kind
  double margin = 0;            // m, see Kind
  Vec3 normal = Vec3::UnitX();  // normal of the plane, unit
  Aabb box;                     // a plane is drawn as far as this box extends; world, m
};

// Two points of the instrument in hand: its tip, and a point of its shaft; world, m.
struct GuidedTip {
  Vec3 tip, shaft;
};

// Distance of the instrument from the guide, m. Targets: distance of the tip from the next target.
// Line: distance between the polyline and the line segment from the tip to the point of the shaft.
// Plane: distance of the tip from the plane. Ball: distance of the tip from the surface of the
// ball; it is negative inside the ball. Returns nothing if the guide has no places, or no next
// target.
std::optional<double> distanceFrom(const Guide& guide, const GuidedTip& tip);

// How well an instrument keeps to a guide. This depends on the distance that distanceFrom() gives:
// - Targets: Well up to the radius, Far beyond it.
// - Line and Plane: Well up to the radius, Near up to twice the radius, Wrong up to 30 mm, and Far
//   beyond 30 mm.
// - Ball: Wrong inside the ball. Outside the ball, Near up to the margin, Well up to 10 mm more
//   than the margin, and Far beyond that.
enum class Keeping { Far, Well, Near, Wrong };
Keeping keepingOf(const Guide& guide, double distance);

// The lines that show a guide. Their colours depend on `keeping`. Targets and balls are shown as
// circles. These circles are perpendicular to `towardsEye`, the unit vector towards the viewer. A
// ball has one more circle, which is horizontal.
std::vector<MarkLine> guideLines(const Guide& guide, Keeping keeping, const Vec3& towardsEye);

}  // namespace resect
