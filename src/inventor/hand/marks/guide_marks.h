// Guidance drawn into the scene: the places of a task's goal, coloured by how well the instrument
// in hand keeps to them. Lines, seen through tissue too.
#pragma once

#include <optional>
#include <vector>

#include "inventor/hand/marks/line_marks.h"

namespace resect {

struct Guide {
  enum class Kind {
    Targets,  // `places`, of which `next` is to be touched, within `radius`
    Line,     // through `places`, to be kept to within `radius`
    Plane,    // through places[0] across `normal`, to be kept to within `radius`
    Ball      // a structure round places[0] that reaches `radius`, and a margin round it
  };
  Kind kind = Kind::Targets;
  std::vector<Vec3> places;  // world, m
  std::size_t next = 0;
  double radius = 0.006;        // m
  double margin = 0;            // m
  Vec3 normal = Vec3::UnitX();  // unit
  Aabb box;                     // within which a plane is drawn
};

// The instrument in hand: its tip, and a point of its shaft, world, m.
struct GuidedTip {
  Vec3 tip, shaft;
};

// Distance, m, of the instrument from the next target, from the line, from the plane, or from the
// structure's surface (negative: within it). None if there is nothing to keep to.
std::optional<double> distanceFrom(const Guide& guide, const GuidedTip& tip);

// Far: it is not near yet. Well: within the radius, or just outside of the margin. Near: up to
// twice the radius, or within the margin. Wrong: farther off, or in the structure.
enum class Keeping { Far, Well, Near, Wrong };
Keeping keepingOf(const Guide& guide, double distance);

// towardsEye: unit; rings face it.
std::vector<MarkLine> guideLines(const Guide& guide, Keeping keeping, const Vec3& towardsEye);

}  // namespace resect
