// A part of an organ, given by geometry and never by cell numbers, so that it holds at any spacing:
// a box or a ball, in the world or relative to the organ, and a depth under its surface.
// docs/scenarios.md, "Regions", has the keys by which files name one.
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "collision/signed_distance.h"
#include "geometry/aabb.h"

namespace resect {

// A named point of an organ, in fractions of its box: (0, 0, 0) at the lowest corner, (1, 1, 1) at
// the highest.
struct Landmark {
  std::string name;
  Vec3 place = Vec3::Zero();
};

struct Region {
  enum class Shape { Whole, Box, Ball };
  enum class Frame {
    World,  // at rest, m
    Organ   // fractions of the organ's box at rest, 0 to 1 on each axis
  };
  Shape shape = Shape::Box;
  Frame frame = Frame::World;  // of box and centre; a radius is in metres always
  Aabb box;
  Vec3 centre = Vec3::Zero();  // of the ball
  double radius = 0;           // > 0, m
  std::string landmark;        // if not empty: the ball's centre is this landmark
  // Depth inwards from the organ's surface, m. A particle whose centre lies outside the surface
  // counts as at depth 0.
  double shallowest = 0;
  double deepest = std::numeric_limits<double>::infinity();
  // Of the organ at rest; required if a depth is given.
  std::shared_ptr<const SignedDistance> skin;

  bool asksDepth() const {
    return shallowest > 0 || deepest < std::numeric_limits<double>::infinity();
  }
  // Whether it is in metres of the world and has all that holds() needs.
  bool isPlaced() const {
    return frame == Frame::World && landmark.empty() && (skin || !asksDepth());
  }
  // Whether a point of the world lies in the region, which must be placed.
  bool holds(const Vec3& p) const;
};

// The position of a landmark in fractions, if there is one of that name; of several the last
// counts.
std::optional<Vec3> landmarkPlace(const std::vector<Landmark>& landmarks, const std::string& name);

// A point given in fractions of a box, m.
inline Vec3 pointInBox(const Aabb& box, const Vec3& fractions) {
  return box.min + fractions.cwiseProduct(box.size());
}

// The region in metres of the world, for an organ that fills `box`. Throws Error when it names a
// landmark that there is not. Depths still need `skin`.
Region inWorld(Region region, const Aabb& box, const std::vector<Landmark>& landmarks);

}  // namespace resect
