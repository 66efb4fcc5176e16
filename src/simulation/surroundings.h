// What stands still round the organs and stops moving tissue.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/triangle_mesh.h"

namespace resect {

// A rigid body that stands still, such as the walls of the tool box.
struct StandingBody {
  std::string name;
  TriangleMesh shape;  // closed
  Pose pose;           // of the shape in the world
  // Side of the cells of the grid of distances to the body, m; 0: a third of a tissue cell, 1 to 3
  // mm. The grid takes as long to make as it has cells.
  double cell = 0;

  template <class Visitor>
  void visit(Visitor& v) {
    v("name", name), v("shape", shape), v("pose", pose), v("cell", cell);
  }
};

// Where the table ends, and the floor onto which tissue falls beyond.
struct TableEdge {
  double halfWidth = 0, halfDepth = 0;  // along x and z, m
  double floor = 0;                     // height, m

  template <class Visitor>
  void visit(Visitor& v) {
    v("halfWidth", halfWidth), v("halfDepth", halfDepth), v("floor", floor);
  }
};

struct Surroundings {
  std::vector<StandingBody> bodies;
  std::optional<TableEdge> edge;  // none: the table has no end

  template <class Visitor>
  void visit(Visitor& v) {
    v("bodies", bodies), v("edge", edge);
  }
};

}  // namespace resect
