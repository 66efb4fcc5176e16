// Triangles of FaceSet and QuadMesh nodes.
//
// Resect converts these two kinds of node itself, with range checks. Coin would read out of bounds
// if an index or a count is wrong. The three kinds of shape that the thesis used (IndexedFaceSet,
// TriangleStripSet and IndexedTriangleStripSet) have headers of their own in this folder.
#pragma once

#include <span>
#include <string>

#include "geometry/triangle_mesh.h"

class SoFaceSet;
class SoQuadMesh;

namespace resect {

// Appends the faces' triangles to `triangles`, as indices into `points` (the coordinates in effect
// at the node). Each run of points (point_runs.h) is a polygon. If a face needs more points than
// exist, throws an Error whose sentence begins with `where`.
void appendTriangles(const SoFaceSet& shape, std::span<const Vec3> points, const std::string& where,
                     std::vector<Triangle>& triangles);

// As above, for a mesh of verticesPerColumn rows, each of verticesPerRow points. The first point of
// the mesh has the index startIndex. As in Coin, each quadrilateral is split from its first corner
// to the opposite one. A mesh of fewer than two rows or columns adds nothing.
void appendTriangles(const SoQuadMesh& shape, std::span<const Vec3> points,
                     const std::string& where, std::vector<Triangle>& triangles);

}  // namespace resect
