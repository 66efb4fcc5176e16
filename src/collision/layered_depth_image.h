// Which part of a box does a body fill, kept as stretches of parallel lines? And which part do two?
//
// A pixel is a column along z at the pixel's centre; it holds the stretches that lie inside,
// clipped to the box (the volume of interest). Lines always run along z: what isInside answers does
// not depend on it, the error of the volume shrinks with the pixels whatever the direction, and one
// raster per mesh serves every question. Source: Heidelberger, Teschner, Gross (2003).
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "collision/inside_query.h"

namespace resect {

struct DepthInterval {
  double entry, exit;  // z, m; entry < exit
};

class LayeredDepthImage {
 public:
  LayeredDepthImage() = default;  // of nothing: no pixels, nothing inside

  // The inside of a closed, oriented mesh in the box, by columnsX x columnsY pixels, each >= 1. The
  // box must have room on every axis. Throws Error, beginning with `name`, when a column enters
  // more often than it leaves: the mesh is open.
  static LayeredDepthImage ofMesh(std::shared_ptr<const TriangleMesh> mesh, const Aabb& box,
                                  int columnsX, int columnsY, const char* name);
  // Pixelwise common part of two images of the same box and size.
  static LayeredDepthImage intersection(const LayeredDepthImage& a, const LayeredDepthImage& b);

  // Most stretches that a pixel holds; 0 if no pixel meets anything.
  int depth() const;
  // Sum of the stretches times the pixel's area, m^3: a discrete volume.
  double volume() const;
  // Is the point in the box and inside the body (both bodies)? Exact: asks the meshes along the
  // column through the point itself, not the nearest pixel.
  bool isInside(const Vec3& p) const;

  const Aabb& box() const { return box_; }
  int columnsX() const { return columnsX_; }
  int columnsY() const { return columnsY_; }
  // Stretches of pixel (i, j) upwards; they do not touch each other.
  std::span<const DepthInterval> pixel(int i, int j) const;
  // x, y of the pixel's column, m.
  Vec2 pixelCentre(int i, int j) const;

 private:
  Aabb box_;
  int columnsX_ = 0, columnsY_ = 0;
  std::vector<std::size_t> offsets_{0};
  std::vector<DepthInterval> intervals_;
  std::vector<std::shared_ptr<const InsideQuery>> bodies_;
};

}  // namespace resect
