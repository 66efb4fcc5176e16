// Examines whether a mesh can be the surface of an organ, and if not, what is wrong with it.
#pragma once

#include <optional>
#include <vector>

#include "geometry/topology.h"
#include "geometry/triangle_mesh.h"

namespace resect {

struct MeshHealth {
  int triangles = 0, points = 0;
  double area = 0;     // m^2
  double volume = 0;   // m^3, signed, see volume() in measures.h
  Aabb bounds;         // m
  int components = 0;  // parts that have no point in common
  int specks = 0;      // components with isSpeck(); 0 unless closed and oriented
  bool closed = false;
  bool oriented = false;
  bool insideOut = false;    // closed and oriented, but an outermost component faces inwards
  int boundaryEdges = 0;     // edges of an odd number of triangles
  int nonManifoldEdges = 0;  // edges of more than two triangles
  std::optional<Vec3> firstBoundaryPoint;  // midpoint of the first boundary edge, m
};

// Examines a welded mesh without changing it. O(n log n) if its bodies are disjoint or nested. An
// empty mesh has no component and does not count as closed.
MeshHealth examine(const TriangleMesh& mesh);
// The same for a caller that has already computed the topology of the mesh.
MeshHealth examine(const TriangleMesh& mesh, const Topology& topology);

// Whether a closed component has practically no volume: at most a millionth of the volume of a ball
// with the same surface area. Examples: two coincident sheets, a needle, a folded triangle.
bool isSpeck(const TriangleMesh& component);

// For each closed component: the number of the outermost component that contains it, or its own
// number if no component does. A component counts as inside another one if at least three of five
// tested points of it are inside (crossings.h).
std::vector<int> outermostOf(const std::vector<TriangleMesh>& components);

}  // namespace resect
