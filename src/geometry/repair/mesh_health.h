// Whether a mesh can be the surface of an organ, and what is wrong with it if not.
#pragma once

#include <optional>
#include <vector>

#include "geometry/topology.h"
#include "geometry/triangle_mesh.h"

namespace resect {

struct MeshHealth {
  int triangles = 0, points = 0;
  double area = 0;    // m^2
  double volume = 0;  // m^3, signed, see volume() in measures.h
  Aabb bounds;        // m
  int components = 0;
  int specks = 0;  // components for which isSpeck(); only counted if closed and oriented
  bool closed = false;
  bool oriented = false;
  bool insideOut = false;  // closed and oriented, but an outermost component faces inwards
  int boundaryEdges = 0;
  int nonManifoldEdges = 0;
  std::optional<Vec3> firstBoundaryPoint;  // midpoint of the first open edge, m
};

// Examines a welded mesh without changing it. O(n log n) for disjoint or nested bodies. An empty
// mesh has no component and is not closed.
MeshHealth examine(const TriangleMesh& mesh);
// The same for a caller that has the mesh's topology already.
MeshHealth examine(const TriangleMesh& mesh, const Topology& topology);

// Whether a closed component has practically no volume: at most a millionth of the volume of a ball
// with the same surface area. Examples: two coincident sheets, a needle, a folded triangle.
bool isSpeck(const TriangleMesh& component);

// For each closed component: the number of the outermost component that contains it, or its own
// number if none does. Whether one contains another is decided by the majority of five points of
// the inner one (crossings.h).
std::vector<int> outermostOf(const std::vector<TriangleMesh>& components);

}  // namespace resect
