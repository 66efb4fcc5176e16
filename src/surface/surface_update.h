// Changes of an organ's surface, for viewers and graphics cards that hold a copy of it.
//
// Three kinds of change: new vertices, moved vertices, new triangles. Each is a list of ranges of
// the surface's arrays and, range by range, the present values; a later range overwrites an earlier
// one. Tissue that only moves sends points and normals: 24 bytes a vertex. Cost of everything here:
// the changes.
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
  std::vector<float> cut;   // 0 = capsule, 1 = cut parenchyma

  std::vector<IndexRange> movedVertices;  // new vertices included
  std::vector<Vec3f> points, normals;     // now, world, m; unit, outwards

  std::vector<IndexRange> newTriangles;
  std::vector<Triangle> triangles;  // indices into all vertices; {0, 0, 0} = a hole

  bool empty() const {
    return !everything && newVertices.empty() && movedVertices.empty() && newTriangles.empty();
  }
};

// Adds a range with its part of the surface's arrays. Empty ranges are left out.
void addNewVertices(SurfaceUpdate& update, IndexRange range, std::span<const Vec3f> rest,
                    std::span<const float> cut);
void addMovedVertices(SurfaceUpdate& update, IndexRange range, std::span<const Vec3f> points,
                      std::span<const Vec3f> normals);
void addNewTriangles(SurfaceUpdate& update, IndexRange range, std::span<const Triangle> triangles);

// The update that turns any copy into this surface. Spans of vertices are equally long, but `rest`
// may be empty: then the tissue is at rest.
SurfaceUpdate wholeSurface(std::span<const Vec3f> points, std::span<const Vec3f> normals,
                           std::span<const float> cut, std::span<const Triangle> triangles,
                           std::span<const Vec3f> rest = {});

// A copy that follows the updates.
struct SurfaceCopy {
  std::vector<Vec3f> points, normals, rest;
  std::vector<float> cut;
  std::vector<Triangle> triangles;
};

// Ranges may reach beyond the present end: the copy grows; triangles in between are holes. Error,
// and nothing changes, when ranges do not fit their values.
void apply(const SurfaceUpdate& update, SurfaceCopy& copy);

}  // namespace resect
