// Where is an organ held by the body it lies in? Regions of rest space, by name of a place and
// never by cell numbers, so that they hold at any spacing.
#pragma once

#include <string>

#include "geometry/aabb.h"

namespace resect {

struct TissueAttachment {
  enum class Kind {
    Pin,      // the cells do not move
    Ligament  // each cell is drawn back to its rest position by a spring
  };
  enum class Shape { Box, Ball };
  Kind kind = Kind::Pin;
  Shape shape = Shape::Box;
  Aabb box;                    // world, at rest, m
  Vec3 centre = Vec3::Zero();  // of the ball
  double radius = 0;           // > 0, m
  double stiffness = 200;      // of the whole ligament, N/m, spread over its cells

  bool holds(const Vec3& p) const {
    return shape == Shape::Box ? box.contains(p) : (p - centre).norm() <= radius;
  }
};

}  // namespace resect
