// Whether a mesh is closed, consistently oriented and manifold, and its connected components.
//
// Counts by sorted edges: O(n log n), deterministic. Points are identified by index; weld first
// (geometry/repair/weld.h) when a reader repeats positions.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/triangle_mesh.h"

namespace resect {

struct Topology {
  int boundaryEdges = 0;     // edges of an odd number of triangles: where the surface is open
  int nonManifoldEdges = 0;  // edges of more than two triangles
  int unorientedEdges = 0;   // edges whose two directions are not used equally often; at a
                             // boundary edge one more use is allowed
  int components = 0;        // pieces connected over shared points
  std::optional<Vec3> firstBoundaryPoint;  // midpoint of the first open edge

  bool closed() const { return boundaryEdges == 0; }
  bool oriented() const { return unorientedEdges == 0; }
  bool manifold() const { return nonManifoldEdges == 0; }
};

// An empty mesh is closed, oriented and has no component.
Topology topology(const TriangleMesh& mesh);

// Component of every point, numbered in the order of the first point; points used by no triangle
// get -1.
std::vector<std::int32_t> pointComponents(const TriangleMesh& mesh, int* count = nullptr);

// One mesh per component, in the order of pointComponents; each keeps the relative order of points
// and triangles.
std::vector<TriangleMesh> splitComponents(const TriangleMesh& mesh);

}  // namespace resect
