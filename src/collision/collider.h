// Layered depth images of closed bodies and the volume that two bodies share, in the three stages
// of the original thesis (2004, sections 2.2.1 and 4.3), each a function:
//
//     const Aabb common = intersection(bounds(organ), bounds(tool));         // volume of interest
//     const ColumnGrid pixels = pixelsOver(common, 64);
//     const LayeredDepthImage a = layeredDepthImage(organ, common, pixels);  // of each body
//     const LayeredDepthImage b = layeredDepthImage(tool, common, pixels);
//     const LayeredDepthImage both = intersectionVolume(a, b);               // common part
//     volume(both);
//
// For single points use insideFlags(), for moving tools sweptInside() (collision/inside.h): they
// are exact, a lookup in the nearest pixel is not.
//
// A pixel is a column along z at its centre; it holds the intervals inside the body, clipped to the
// volume of interest. Columns always run along z: the error of the volume shrinks with pixel size
// in any direction, and one raster per mesh serves all queries. Source: Heidelberger, Teschner,
// Gross (2003).
#pragma once

#include <span>
#include <vector>

#include "collision/columns.h"

namespace resect {

// Nearly square pixels over a box in x and y, `resolution` >= 1 along its longer side. None for an
// empty or flat box.
ColumnGrid pixelsOver(const Aabb& box, int resolution);

struct DepthInterval {
  double entry, exit;  // z, m; entry < exit
};

struct LayeredDepthImage {
  ColumnGrid pixels;
  std::vector<std::uint32_t> offsets{0};  // pixels + 1 entries
  std::vector<DepthInterval> intervals;
  // Pixels whose column enters and leaves the mesh unequally often: the mesh is open there.
  std::int64_t openPixels = 0;

  // Intervals of pixel j * pixels.countX + i, ascending; they do not touch each other.
  std::span<const DepthInterval> operator[](std::size_t pixel) const {
    return {intervals.data() + offsets[pixel], intervals.data() + offsets[pixel + 1]};
  }
};

// Rasterises the inside of a closed, oriented, finite mesh within the box. wanted: one flag per
// pixel, or none for all; pixels that are not wanted stay empty, and the mesh may be incomplete
// there. Cost: a pass over the mesh and the crossings.
LayeredDepthImage layeredDepthImage(const TriangleMesh& mesh, const Aabb& box,
                                    const ColumnGrid& pixels,
                                    std::span<const std::uint8_t> wanted = {});

// One flag per pixel: 1 if it has an interval.
std::vector<std::uint8_t> coveredPixels(const LayeredDepthImage& image);

// Pixelwise common part of two images of the same box and pixels.
LayeredDepthImage intersectionVolume(const LayeredDepthImage& a, const LayeredDepthImage& b);

// Sum of the intervals times a pixel's area, m^3.
double volume(const LayeredDepthImage& image);

}  // namespace resect
