// Converts FaceSet and QuadMesh nodes to triangles.
//
// Resect has its own converters for these two kinds of node, since Coin (the Inventor library)
// reads out of bounds if an index or a count in the node is wrong. The converters check all indices
// and counts. In this folder there are also converters for IndexedFaceSet, TriangleStripSet and
// IndexedTriangleStripSet nodes.
#pragma once

#include <span>
#include <string>

#include "geometry/triangle_mesh.h"

class SoFaceSet;
class SoQuadMesh;

namespace resect {

// Appends the triangles of the node's faces to `triangles`. Each face is a run of points
// (inventor/reading/point_runs.h). points: the coordinates that are in effect at the node; the
// triangles contain indices of these points. If a face needs more points than exist, throws an
// Error that begins with `where`.
void appendTriangles(const SoFaceSet& shape, std::span<const Vec3> points, const std::string& where,
                     std::vector<Triangle>& triangles);

// The same for a QuadMesh node. The points of the mesh form rows: verticesPerColumn rows of
// verticesPerRow points each. The first point of the mesh has the index startIndex. Each
// quadrilateral is divided by the diagonal from its first corner to the opposite corner, as in
// Coin. A mesh with fewer than two rows or columns adds nothing.
void appendTriangles(const SoQuadMesh& shape, std::span<const Vec3> points,
                     const std::string& where, std::vector<Triangle>& triangles);

}  // namespace resect
