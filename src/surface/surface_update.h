// Changes of an organ's surface, for viewers and graphics cards that hold a copy of it.
//
// There are three kinds of change: new vertices, moved vertices and new triangles. For each kind
// there is a list of ranges of the surface's arrays. Further lists hold the present values in these
// ranges, range after range. Where two ranges overlap, the values of the later range count. For
// tissue that only moves, an update holds only points and normals: 24 bytes per vertex. The cost of
// each function here is proportional to the size of the update.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "base/vec.h"
#include "geometry/triangle_mesh.h"
#include "surface/index_range.h"
#include "surface/tissue_map.h"
#include "surface/vessel_picture.h"

namespace resect {

struct SurfaceUpdate {
  bool everything = false;  // true: all earlier vertices and triangles are void

  std::vector<IndexRange> newVertices;
  std::vector<Vec3f> rest;  // rest positions, m
  // Cut shares, from 0 on the organ's original surface to 1 on cut faces; kRimShare where a cut
  // meets the surface.
  std::vector<float> cut;

  std::vector<IndexRange> movedVertices;  // including the new vertices
  std::vector<Vec3f> points, normals;     // present positions (world, m); normals (unit, outwards)

  std::vector<IndexRange> newTriangles;
  std::vector<Triangle> triangles;  // indices of vertices of the whole surface; {0, 0, 0}: unused

  std::shared_ptr<const TissueMap> blood, heat;  // null: unchanged
  // The organ's structures and vessels; given only if `everything` is true.
  std::shared_ptr<const TissueMap> structures;
  std::shared_ptr<const VesselPicture> vessels;

  bool empty() const {
    return !everything && newVertices.empty() && movedVertices.empty() && newTriangles.empty() &&
           !blood && !heat && !structures && !vessels;
  }
};

// These functions add a range of the surface's arrays to the update, with the values in this range.
// The spans are the whole arrays. An empty range is left out.
void addNewVertices(SurfaceUpdate& update, IndexRange range, std::span<const Vec3f> rest,
                    std::span<const float> cut);
void addMovedVertices(SurfaceUpdate& update, IndexRange range, std::span<const Vec3f> points,
                      std::span<const Vec3f> normals);
void addNewTriangles(SurfaceUpdate& update, IndexRange range, std::span<const Triangle> triangles);

// The update that turns any copy into the surface that the arguments describe. All arguments except
// `triangles` have one element per vertex. `rest` may be empty; then the tissue is at rest.
SurfaceUpdate wholeSurface(std::span<const Vec3f> points, std::span<const Vec3f> normals,
                           std::span<const float> cut, std::span<const Triangle> triangles,
                           std::span<const Vec3f> rest = {});

// A copy of the surface, which apply() keeps up to date.
struct SurfaceCopy {
  std::vector<Vec3f> points, normals, rest;
  std::vector<float> cut;
  std::vector<Triangle> triangles;
};

// Writes an update into a copy. If a range reaches beyond the end of the copy's arrays, the arrays
// grow. If the update gives no value for a triangle that is added in this way, the triangle is
// unused, {0, 0, 0}. Throws Error, and changes nothing, if the number of values in the update
// differs from the total size of the ranges.
void apply(const SurfaceUpdate& update, SurfaceCopy& copy);

}  // namespace resect
