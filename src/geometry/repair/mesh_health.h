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
  double volume = 0;  // m^3, signed, see measures.h
  Aabb bounds;        // m
  int components = 0;
  int specks = 0;  // components without volume, see isSpeck
  bool closed = false;
  bool oriented = false;
  bool insideOut = false;  // closed, oriented, and an outermost component is oriented inwards
  int boundaryEdges = 0;
  int nonManifoldEdges = 0;
  std::optional<Vec3> firstBoundaryPoint;  // midpoint of the first open edge, m
};

// Examines a welded mesh without changing it. O(n log n) for disjoint or nested bodies. An empty
// mesh has no component and is not closed.
MeshHealth examine(const TriangleMesh& mesh);
// The same where the mesh's topology is known already.
MeshHealth examine(const TriangleMesh& mesh, const Topology& topology);

// Whether a closed component has practically no volume: less than a millionth of that of a ball of
// the same area. Examples: two coincident sheets, a needle, a folded triangle.
bool isSpeck(const TriangleMesh& component);

// For each closed component the outermost component that it lies in, itself when it is outermost.
// Decided by a vote of five of its points (crossings.h).
std::vector<int> outermostOf(const std::vector<TriangleMesh>& components);

}  // namespace resect
