// Triangles of FaceSet and QuadMesh nodes.
//
// Converted here like the three shapes of the thesis, with range checks: Coin reads out of bounds
// when an index or count is wrong.
#pragma once

#include <span>
#include <string>

#include "geometry/triangle_mesh.h"

class SoFaceSet;
class SoQuadMesh;

namespace resect {

// Runs of points as for TriangleStripSet; each is a polygon.
void appendTriangles(const SoFaceSet& shape, std::span<const Vec3> points, const std::string& where,
                     std::vector<Triangle>& triangles);

// verticesPerColumn rows of verticesPerRow points, beginning at startIndex; each quadrilateral is
// split from its first corner to the opposite one, as Coin does. Fewer than two rows or columns
// give nothing.
void appendTriangles(const SoQuadMesh& shape, std::span<const Vec3> points,
                     const std::string& where, std::vector<Triangle>& triangles);

}  // namespace resect
