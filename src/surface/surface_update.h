// Changes of an organ's surface, for viewers and graphics cards that hold a copy of it.
//
// There are three kinds of change: new vertices, moved vertices, new triangles. Each is a list of
// ranges of the surface's arrays and, range by range, the present values; a later range overwrites
// an earlier one. Tissue that only moves sends points and normals: 24 bytes per vertex. The cost of
// each function here depends on the size of the update.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "base/vec.h"
#include "geometry/triangle_mesh.h"
#include "surface/index_range.h"

namespace resect {

struct SurfaceUpdate {
  bool everything = false;  // all earlier vertices and triangles are void

  std::vector<IndexRange> newVertices;
  std::vector<Vec3f> rest;  // rest positions, m
  std::vector<float> cut;   // cut shares, 0 to 1

  std::vector<IndexRange> movedVertices;  // new vertices included
  std::vector<Vec3f> points, normals;     // present positions (world, m); normals (unit, outwards)

  std::vector<IndexRange> newTriangles;
  std::vector<Triangle> triangles;  // indices into all vertices; {0, 0, 0} = a hole

  bool empty() const {
    return !everything && newVertices.empty() && movedVertices.empty() && newTriangles.empty();
  }
};

// Adds a range and the values in that range of the surface's arrays, which are given whole. Empty
// ranges are left out.
void addNewVertices(SurfaceUpdate& update, IndexRange range, std::span<const Vec3f> rest,
                    std::span<const float> cut);
void addMovedVertices(SurfaceUpdate& update, IndexRange range, std::span<const Vec3f> points,
                      std::span<const Vec3f> normals);
void addNewTriangles(SurfaceUpdate& update, IndexRange range, std::span<const Triangle> triangles);

// The update that turns any copy into this surface. All spans of vertices have the same length, but
// `rest` may be empty: the tissue is then at rest.
SurfaceUpdate wholeSurface(std::span<const Vec3f> points, std::span<const Vec3f> normals,
                           std::span<const float> cut, std::span<const Triangle> triangles,
                           std::span<const Vec3f> rest = {});

// A copy of the surface, which apply() keeps up to date.
struct SurfaceCopy {
  std::vector<Vec3f> points, normals, rest;
  std::vector<float> cut;
  std::vector<Triangle> triangles;
};

// Writes an update into a copy. If a range reaches beyond the copy's end, the copy grows; new
// triangles that no range holds are holes. Throws Error, and changes nothing, when the ranges do
// not fit the number of values.
void apply(const SurfaceUpdate& update, SurfaceCopy& copy);

}  // namespace resect
