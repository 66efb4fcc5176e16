// What is new about an organ's surface, for somebody who holds a copy of it: a viewer, a graphics
// card?
//
// Three kinds of change: vertices that are new, vertices that are at another place, triangles that
// are others. Each is a list of ranges of the surface's arrays and, one range after the other, the
// values that stand there now; a later range overwrites an earlier one. Tissue that only moves
// sends points and normals: 24 bytes a vertex. Cost of everything here: the changes.
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
  bool everything = false;  // forget all vertices and triangles that there were

  std::vector<IndexRange> newVertices;
  std::vector<Vec3f> rest;  // where the tissue was at rest, m
  std::vector<float> cut;   // 0 = capsule, 1 = cut parenchyma

  std::vector<IndexRange> movedVertices;  // new ones too
  std::vector<Vec3f> points, normals;     // now, world, m; unit, outwards

  std::vector<IndexRange> newTriangles;
  std::vector<Triangle> triangles;  // indices into all vertices; {0, 0, 0} = a hole

  bool empty() const {
    return !everything && newVertices.empty() && movedVertices.empty() && newTriangles.empty();
  }
};

// Add a range, with its part of the surface's arrays. Ranges of nothing are left out.
void addNewVertices(SurfaceUpdate& update, IndexRange range, std::span<const Vec3f> rest,
                    std::span<const float> cut);
void addMovedVertices(SurfaceUpdate& update, IndexRange range, std::span<const Vec3f> points,
                      std::span<const Vec3f> normals);
void addNewTriangles(SurfaceUpdate& update, IndexRange range, std::span<const Triangle> triangles);

// The update that makes any copy this surface. Spans of vertices are equally long, but `rest` may
// be empty: then the tissue is at rest.
SurfaceUpdate wholeSurface(std::span<const Vec3f> points, std::span<const Vec3f> normals,
                           std::span<const float> cut, std::span<const Triangle> triangles,
                           std::span<const Vec3f> rest = {});

// A copy that follows the updates.
struct SurfaceCopy {
  std::vector<Vec3f> points, normals, rest;
  std::vector<float> cut;
  std::vector<Triangle> triangles;
};

// Ranges may reach beyond the present end: the copy grows; triangles in between are holes. A range
// that does not fit its values is a fault of ours.
void apply(const SurfaceUpdate& update, SurfaceCopy& copy);

}  // namespace resect
