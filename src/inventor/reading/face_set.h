// Triangles of FaceSet and QuadMesh nodes.
//
// These two are converted here, with range checks, and not by Coin, which reads out of bounds if an
// index or a count is wrong. The three shapes of the thesis have headers of their own.
#pragma once

#include <span>
#include <string>

#include "geometry/triangle_mesh.h"

class SoFaceSet;
class SoQuadMesh;

namespace resect {

// Appends the faces' triangles to `triangles`, as indices into `points` (the coordinates in effect
// at the node). Each run of points (point_runs.h) is a polygon. Throws an Error, beginning with
// `where`, if a face needs more points than exist.
void appendTriangles(const SoFaceSet& shape, std::span<const Vec3> points, const std::string& where,
                     std::vector<Triangle>& triangles);

// The same for a mesh of verticesPerColumn rows of verticesPerRow points, the first of them point
// startIndex. As in Coin, each quadrilateral is split from its first corner to the opposite one.
// Fewer than two rows or columns give nothing.
void appendTriangles(const SoQuadMesh& shape, std::span<const Vec3> points,
                     const std::string& where, std::vector<Triangle>& triangles);

}  // namespace resect
