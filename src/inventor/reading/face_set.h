// Which triangles do a FaceSet, a QuadMesh and a VRML IndexedFaceSet stand for?
//
// Converted here like the three shapes of the thesis, because their ranges must be checked anyway:
// Coin reads beyond the end when an index or count is wrong.
#pragma once

#include <span>
#include <string>

#include "geometry/triangle_mesh.h"

class SoFaceSet;
class SoQuadMesh;

namespace resect {

// As for TriangleStripSet, each run of points being a polygon.
void appendTriangles(const SoFaceSet& shape, std::span<const Vec3> points, const std::string& where,
                     std::vector<Triangle>& triangles);

// verticesPerColumn rows of verticesPerRow points, beginning at startIndex; each quadrilateral is
// cut from its first corner to the opposite one, as Coin does. Fewer than two rows or columns give
// nothing.
void appendTriangles(const SoQuadMesh& shape, std::span<const Vec3> points,
                     const std::string& where, std::vector<Triangle>& triangles);

}  // namespace resect
