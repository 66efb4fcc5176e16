// Guidance drawn into the scene: the places of a task's goal, coloured by how well the instrument
// in hand keeps to them. Lines, seen through tissue too.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "geometry/aabb.h"

class SoBaseColor;
class SoCoordinate3;
class SoLineSet;
class SoSeparator;
class SoSwitch;

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

class GuideMarks {
 public:
  explicit GuideMarks(SoSeparator* parent);
  ~GuideMarks();
  GuideMarks(const GuideMarks&) = delete;
  GuideMarks& operator=(const GuideMarks&) = delete;

  // towardsEye: unit; rings face it. Returns the box, world, m, of what has to be drawn again:
  // empty if nothing changed visibly.
  Aabb show(const Guide& guide, Keeping keeping, const Vec3& towardsEye);
  Aabb hide();

 private:
  struct Stroke {
    Vec3f colour;
    std::vector<Vec3> points;
  };
  static std::vector<Stroke> linesOf(const Guide& guide, Keeping keeping, const Vec3& towardsEye);

  SoSeparator* parent_;
  SoSwitch* root_;
  SoBaseColor* colours_;
  SoCoordinate3* corners_;
  SoLineSet* lines_;
  std::vector<Stroke> shown_;
  Aabb box_;  // of what is shown
};

}  // namespace resect
