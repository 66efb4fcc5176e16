// Topology of a mesh: whether it is closed, consistently oriented and manifold; its components.
//
// Sorts the edges and counts them: O(n log n), deterministic. Points are told apart by index, not
// by position: a mesh that repeats positions must be welded first (geometry/repair/weld.h).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/triangle_mesh.h"

namespace resect {

struct Topology {
  int boundaryEdges = 0;     // edges of an odd number of triangles: where the surface is open
  int nonManifoldEdges = 0;  // edges of more than two triangles
  // Edges that their triangles do not use equally often in both directions; a boundary edge may
  // have one use more in one of them.
  int unorientedEdges = 0;
  int components = 0;                      // parts of the mesh that have no point in common
  std::optional<Vec3> firstBoundaryPoint;  // midpoint of the first boundary edge, m

  bool closed() const { return boundaryEdges == 0; }
  bool oriented() const { return unorientedEdges == 0; }
  bool manifold() const { return nonManifoldEdges == 0; }
};

// An empty mesh is closed, oriented and has no component.
Topology topology(const TriangleMesh& mesh);

// For each point the number of its component. Components are numbered from 0 in the order of their
// first points. Points that no triangle uses get -1.
std::vector<std::int32_t> pointComponents(const TriangleMesh& mesh, int* count = nullptr);

// One mesh per component, in the order of pointComponents(). Points and triangles keep their order
// within each.
std::vector<TriangleMesh> splitComponents(const TriangleMesh& mesh);

}  // namespace resect
