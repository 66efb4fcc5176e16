// Can this surface be the skin of an organ, and if not, what is wrong with it?
#pragma once

#include <optional>
#include <vector>

#include "geometry/topology.h"
#include "geometry/triangle_mesh.h"

namespace resect {

struct MeshHealth {
  int triangles = 0, points = 0;
  double area = 0;    // m^2
  double volume = 0;  // m^3, signed, see measures.h
  Aabb bounds;        // m
  int components = 0;
  int specks = 0;  // components without volume, see isSpeck
  bool closed = false;
  bool oriented = false;
  bool insideOut = false;  // closed, oriented, and an outermost component looks inwards
  int boundaryEdges = 0;
  int nonManifoldEdges = 0;
  std::optional<Vec3> firstBoundaryPoint;  // midpoint of the first open edge, m
};

// Looks at a welded mesh; nothing is changed. O(n log n) for bodies side by side or in one another.
// An empty mesh has no component and is not closed.
MeshHealth examine(const TriangleMesh& mesh);
// The same where the mesh's topology is known already.
MeshHealth examine(const TriangleMesh& mesh, const Topology& topology);

// Is a closed component too thin to hold anything: less than a millionth of what a ball of the same
// area holds? Two sheets on each other, a needle, a folded triangle.
bool isSpeck(const TriangleMesh& component);

// For each closed component the outermost component that it lies in, itself when it is outermost.
// Decided by five points of it (crossings.h).
std::vector<int> outermostOf(const std::vector<TriangleMesh>& components);

}  // namespace resect
