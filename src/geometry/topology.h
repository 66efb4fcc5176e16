// Topology of a mesh: whether it is closed, consistently oriented and manifold; its components.
//
// Sorts the edges and counts them: O(n log n), deterministic. Two points are the same if they have
// the same index; positions do not matter. So a mesh that repeats positions must be welded first
// (geometry/repair/weld.h).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/triangle_mesh.h"

namespace resect {

struct Topology {
  int boundaryEdges = 0;     // edges of an odd number of triangles: where the surface is open
  int nonManifoldEdges = 0;  // edges of more than two triangles
  // Each triangle uses its edges in one direction. This is the number of edges that are not used
  // equally often in both directions. A boundary edge is counted only if the two numbers of uses
  // differ by more than one.
  int unorientedEdges = 0;
  int components = 0;                      // parts of the mesh that have no point in common
  std::optional<Vec3> firstBoundaryPoint;  // midpoint of the first boundary edge, m

  bool closed() const { return boundaryEdges == 0; }
  bool oriented() const { return unorientedEdges == 0; }
  bool manifold() const { return nonManifoldEdges == 0; }
};

// An empty mesh is closed, oriented and manifold, and has no component.
Topology topology(const TriangleMesh& mesh);

// For each point the number of its component. Components are numbered from 0 in the order of their
// first points. Points that no triangle uses get -1. `count`, if given, receives the number of
// components.
std::vector<std::int32_t> pointComponents(const TriangleMesh& mesh, int* count = nullptr);

// One mesh per component, in the order of pointComponents(). Within each mesh points and triangles
// keep their order. Points that no triangle uses are dropped.
std::vector<TriangleMesh> splitComponents(const TriangleMesh& mesh);

}  // namespace resect
