// Examines whether a mesh can be the surface of an organ. If it cannot, the result shows what is
// wrong with the mesh.
#pragma once

#include <optional>
#include <vector>

#include "geometry/topology.h"
#include "geometry/triangle_mesh.h"

namespace resect {

struct MeshHealth {
  int triangles = 0, points = 0;
  double area = 0;     // m^2
  double volume = 0;   // m^3, signed (volume() in geometry/measures.h)
  Aabb bounds;         // m
  int components = 0;  // number of parts that have no point in common
  // Number of components without volume (isSpeck()). It is 0 if the mesh is open or not oriented.
  int specks = 0;
  bool closed = false;
  bool oriented = false;
  // True if the mesh is closed and oriented, but at least one outermost component faces inwards. A
  // component is outermost if no other component contains it.
  bool insideOut = false;
  int boundaryEdges = 0;     // number of edges that belong to an odd number of triangles
  int nonManifoldEdges = 0;  // number of edges that belong to more than two triangles
  std::optional<Vec3> firstBoundaryPoint;  // midpoint of the first boundary edge, m
};

// Examines a welded mesh. An empty mesh has no component and does not count as closed. Cost: O(n
// log n) for n triangles if the components are disjoint or nested.
MeshHealth examine(const TriangleMesh& mesh);
// Does the same for a caller that has already computed the topology of the mesh.
MeshHealth examine(const TriangleMesh& mesh, const Topology& topology);

// Whether a closed component has practically no volume: at most a millionth of the volume of a ball
// with the same surface area. Examples: two coincident sheets, a needle, a folded triangle.
bool isSpeck(const TriangleMesh& component);

// For each closed component: the index of the outermost component that contains it, or its own
// index if no component contains it. Component A counts as inside component B if at least three of
// five tested points of A are inside B (geometry/repair/crossings.h).
std::vector<int> outermostOf(const std::vector<TriangleMesh>& components);

}  // namespace resect
