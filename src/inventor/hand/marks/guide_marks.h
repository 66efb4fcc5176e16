// Guidance drawn into the scene: lines that mark the places of a task's goal. Their colour shows
// how well the instrument in hand keeps to the goal. They are visible through tissue too.
#pragma once

#include <optional>
#include <vector>

#include "inventor/hand/marks/line_marks.h"

namespace resect {

struct Guide {
  enum class Kind {
    Targets,  // touch places[next] within `radius`
    Line,     // keep within `radius` of the polyline through `places`
    Plane,    // keep within `radius` of the plane through places[0]
    Ball      // keep `margin` away from a structure: a ball with `radius` round places[0]
  };
  Kind kind = Kind::Targets;
  std::vector<Vec3> places;     // world, m
  std::size_t next = 0;         // index in `places` of the next target
  double radius = 0.006;        // m
  double margin = 0;            // m
  Vec3 normal = Vec3::UnitX();  // of the plane, unit
  Aabb box;                     // the part of a plane that is drawn covers this box; world, m
};

// The instrument in hand: its tip, and a point of its shaft, world, m.
struct GuidedTip {
  Vec3 tip, shaft;
};

// Distance, m, of the instrument from the next target, from the line, from the plane, or from the
// structure's surface (negative: within it). None if there is nothing to keep to.
std::optional<double> distanceFrom(const Guide& guide, const GuidedTip& tip);

// How an instrument keeps to a guide, by its distance (distanceFrom()):
// - Targets: Well up to the radius, otherwise Far.
// - Line and Plane: Well up to the radius, Near up to twice the radius, Wrong up to 30 mm, Far
//   beyond 30 mm.
// - Ball: Wrong in the structure, Near up to the margin, Well up to 10 mm more than the margin, Far
//   beyond that.
enum class Keeping { Far, Well, Near, Wrong };
Keeping keepingOf(const Guide& guide, double distance);

// towardsEye: direction that the rings face, unit.
std::vector<MarkLine> guideLines(const Guide& guide, Keeping keeping, const Vec3& towardsEye);

}  // namespace resect
