// What stands round the organs: rigid bodies, which moving tissue cannot enter, and the table's
// edge.
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
  // The distances to the body are stored on a grid. `cell` is the side of the grid's cells, m. 0: a
  // third of a tissue cell, but at least 1 mm and at most 3 mm. The time to make the grid is
  // proportional to the number of its cells.
  double cell = 0;

  template <class Visitor>
  void visit(Visitor& v) {
    v("name", name), v("shape", shape), v("pose", pose), v("cell", cell);
  }
};

// The edge of the table, and the floor onto which tissue falls beyond the edge.
struct TableEdge {
  double halfWidth = 0, halfDepth = 0;  // half of the table's sides along x and z, m
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
