// Layered depth images of closed bodies, and the volume that two bodies share. The work has three
// stages, as in the thesis of 2004 that Resect continues (sections 2.2.1 and 4.3):
//
//     // 1. The volume of interest, and pixels over it.
//     const Aabb common = intersection(bounds(organ), bounds(tool));
//     const ColumnGrid pixels = pixelsOver(common, 64);
//     // 2. A layered depth image of each body.
//     const LayeredDepthImage a = layeredDepthImage(organ, common, pixels);
//     const LayeredDepthImage b = layeredDepthImage(tool, common, pixels);
//     // 3. The part of space that both images contain.
//     const LayeredDepthImage both = intersectionVolume(a, b);
//     volume(both);
//
// For single points, use insideFlags() (collision/inside.h). For moving tools, use sweptInside()
// (in the same header). These functions test the points themselves, and not the nearest pixels.
//
// A pixel stands for the column (line along z) through its centre. The pixel holds those intervals
// of this column that are inside the body, clipped to the volume of interest. All columns run along
// z, so one raster per mesh (collision/columns.h) serves all queries. Another direction would not
// be more exact: in every direction the error of the volume shrinks with the size of the pixels.
// Source: Heidelberger, Teschner, Gross (2003).
#pragma once

#include <span>
#include <vector>

#include "collision/columns.h"

namespace resect {

// Covers the extents of a finite box along x and y with nearly square pixels. `resolution`, at
// least 1: number of pixels along the longer side. An empty or flat box gets no pixels.
ColumnGrid pixelsOver(const Aabb& box, int resolution);

struct DepthInterval {
  double entry, exit;  // z, m; entry < exit
};

struct LayeredDepthImage {
  ColumnGrid pixels;
  // Per pixel: the index in `intervals` of the pixel's first interval. The last entry is the number
  // of all intervals.
  std::vector<std::uint32_t> offsets{0};
  std::vector<DepthInterval> intervals;
  // Number of pixels at which the mesh is open: the pixel's column does not enter the mesh as often
  // as it leaves the mesh.
  std::int64_t openPixels = 0;

  // The intervals of a pixel, ascending. No two intervals touch. Pixel i of row j has the number j
  // * pixels.countX + i.
  std::span<const DepthInterval> operator[](std::size_t pixel) const {
    return {intervals.data() + offsets[pixel], intervals.data() + offsets[pixel + 1]};
  }
};

// Rasterises the inside of a mesh within the box. The mesh must be finite, closed and oriented
// outwards. wanted: one flag per pixel, or empty if all pixels are wanted. Pixels that are not
// wanted get no intervals; over these pixels, parts of the mesh may be missing. Cost: a pass over
// the mesh, and a pass over the crossings of the mesh with the pixels' columns.
LayeredDepthImage layeredDepthImage(const TriangleMesh& mesh, const Aabb& box,
                                    const ColumnGrid& pixels,
                                    std::span<const std::uint8_t> wanted = {});

// One flag per pixel: 1 if the pixel has an interval.
std::vector<std::uint8_t> coveredPixels(const LayeredDepthImage& image);

// The common part of two images, pixel by pixel. Both images must have the same box and the same
// pixels.
LayeredDepthImage intersectionVolume(const LayeredDepthImage& a, const LayeredDepthImage& b);

// The volume that an image shows, m^3: the sum of the lengths of all intervals times the area of a
// pixel.
double volume(const LayeredDepthImage& image);

}  // namespace resect
