// Topology of a mesh: whether the mesh is closed, consistently oriented and manifold, and which
// components it has.
//
// Points are told apart by their indices; their positions do not matter. So a mesh that repeats
// positions must be welded first (geometry/repair/weld.h). The edges are sorted and counted, which
// takes O(n log n) for n triangles. The results are deterministic.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/triangle_mesh.h"

namespace resect {

struct Topology {
  // Number of edges that belong to an odd number of triangles. The surface is open there.
  int boundaryEdges = 0;
  int nonManifoldEdges = 0;  // number of edges that belong to more than two triangles
  // Each triangle uses each of its edges in one direction. This field counts the edges that
  // triangles do not use equally often in both directions. It counts a boundary edge only if the
  // numbers of uses in the two directions differ by more than one.
  int unorientedEdges = 0;
  int components = 0;                      // number of parts that have no point in common
  std::optional<Vec3> firstBoundaryPoint;  // midpoint of the first boundary edge, m

  bool closed() const { return boundaryEdges == 0; }
  bool oriented() const { return unorientedEdges == 0; }
  bool manifold() const { return nonManifoldEdges == 0; }
};

// An empty mesh is closed, oriented and manifold, and has no component.
Topology topology(const TriangleMesh& mesh);

// For each point: the number of the component that it belongs to. Components are numbered from 0,
// in the order of their first points. A point that no triangle uses gets -1. If `count` is not
// null, *count receives the number of components.
std::vector<std::int32_t> pointComponents(const TriangleMesh& mesh, int* count = nullptr);

// One mesh for each component, in the order of the numbers that pointComponents() gives. In each of
// these meshes, points and triangles keep their order. Points that no triangle uses are dropped.
std::vector<TriangleMesh> splitComponents(const TriangleMesh& mesh);

}  // namespace resect
