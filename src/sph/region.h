// A region: a part of an organ. A region is given by geometry and never by cell numbers, so it is
// the same at any spacing. It is a box, a ball or the whole organ. It may be limited to a range of
// depths under the organ's surface. docs/scenarios.md, "Regions", lists the keys with which files
// give a region.
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "collision/signed_distance.h"
#include "geometry/aabb.h"

namespace resect {

// A named point of an organ. Its coordinates are fractions of the organ's box, the bounding box of
// the organ's particles: (0, 0, 0) is the lowest corner of the box, (1, 1, 1) the highest.
struct Landmark {
  std::string name;
  Vec3 place = Vec3::Zero();

  template <class Visitor>
  void visit(Visitor& v) {
    v("name", name), v("place", place);
  }
};

struct Region {
  enum class Shape { Whole, Box, Ball };
  // The coordinates in which a region is given. In both frames the organ is at rest.
  enum class Frame {
    World,  // world coordinates, m
    Organ   // fractions of the organ's box, 0 to 1 on each axis
  };
  Shape shape = Shape::Box;
  Frame frame = Frame::World;  // of `box` and `centre`; `radius` is always in metres
  Aabb box;
  Vec3 centre = Vec3::Zero();  // of the ball
  double radius = 0;           // > 0, m
  std::string landmark;        // if not empty: the landmark at the ball's centre
  // Least and greatest depth inwards from the organ's surface, m. A particle whose centre lies
  // outside the surface counts as being at depth 0.
  double shallowest = 0;
  double deepest = std::numeric_limits<double>::infinity();
  // Signed distance from the surface of the organ at rest; required if a depth is given.
  std::shared_ptr<const SignedDistance> skin;

  template <class Visitor>
  void visit(Visitor& v) {  // all fields but `skin`, which comes from the organ
    v("shape", shape), v("frame", frame), v("box", box), v("centre", centre), v("radius", radius);
    v("landmark", landmark), v("shallowest", shallowest), v("deepest", deepest);
  }

  bool asksDepth() const {
    return shallowest > 0 || deepest < std::numeric_limits<double>::infinity();
  }
  // Whether the region is in world coordinates and has all that holds() needs.
  bool isPlaced() const {
    return frame == Frame::World && landmark.empty() && (skin || !asksDepth());
  }
  // Whether a point of the world lies in the region. isPlaced() must hold.
  bool holds(const Vec3& p) const;
};

// The position of the landmark of that name, in fractions of the organ's box. If several landmarks
// have that name, the last of them counts. If no landmark has it, there is no result.
std::optional<Vec3> landmarkPlace(const std::vector<Landmark>& landmarks, const std::string& name);

// The position, m, of a point that is given in fractions of a box.
inline Vec3 pointInBox(const Aabb& box, const Vec3& fractions) {
  return box.min + fractions.cwiseProduct(box.size());
}

// The region in world coordinates, for an organ that fills `box`. Throws Error if the region names
// a landmark that is not in `landmarks`. Does not set `skin`, which a region with a depth needs.
Region inWorld(Region region, const Aabb& box, const std::vector<Landmark>& landmarks);

}  // namespace resect
