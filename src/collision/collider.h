// Layered depth images of closed bodies and the volume that two bodies share, in the three stages
// of the original thesis (2004, sections 2.2.1 and 4.3), one function for each stage:
//
//     const Aabb common = intersection(bounds(organ), bounds(tool));         // volume of interest
//     const ColumnGrid pixels = pixelsOver(common, 64);
//     const LayeredDepthImage a = layeredDepthImage(organ, common, pixels);  // of each body
//     const LayeredDepthImage b = layeredDepthImage(tool, common, pixels);
//     const LayeredDepthImage both = intersectionVolume(a, b);               // common part
//     volume(both);
//
// For single points use insideFlags(), for moving tools sweptInside() (collision/inside.h): these
// are exact, whereas a look-up in the nearest pixel is not.
//
// A pixel stands for the column along z through its centre and holds the intervals of this column
// that are inside the body, clipped to the volume of interest. Columns always run along z: in any
// direction the error of the volume would shrink with the pixel size, and with one direction one
// raster per mesh serves all queries. Source: Heidelberger, Teschner, Gross (2003).
#pragma once

#include <span>
#include <vector>

#include "collision/columns.h"

namespace resect {

// Covers a box's extent in x and y with nearly square pixels: `resolution` >= 1 of them along the
// longer side. An empty or flat box gets no pixels.
ColumnGrid pixelsOver(const Aabb& box, int resolution);

struct DepthInterval {
  double entry, exit;  // z, m; entry < exit
};

struct LayeredDepthImage {
  ColumnGrid pixels;
  std::vector<std::uint32_t> offsets{0};  // first interval of each pixel; then the end
  std::vector<DepthInterval> intervals;
  // Number of pixels whose column does not enter the mesh as often as it leaves it: there the mesh
  // is open.
  std::int64_t openPixels = 0;

  // The intervals of a pixel, ascending; they do not touch each other. Pixel i of row j has the
  // number j * pixels.countX + i.
  std::span<const DepthInterval> operator[](std::size_t pixel) const {
    return {intervals.data() + offsets[pixel], intervals.data() + offsets[pixel + 1]};
  }
};

// Rasterises the inside of a closed, oriented, finite mesh within the box. wanted: one flag per
// pixel, or empty if all pixels are wanted. Pixels that are not wanted stay empty; over them the
// mesh may be incomplete. Cost: a pass over the mesh and the crossings.
LayeredDepthImage layeredDepthImage(const TriangleMesh& mesh, const Aabb& box,
                                    const ColumnGrid& pixels,
                                    std::span<const std::uint8_t> wanted = {});

// One flag per pixel: 1 if it has an interval.
std::vector<std::uint8_t> coveredPixels(const LayeredDepthImage& image);

// The common part of two images, pixel by pixel. Both must have the same box and pixels.
LayeredDepthImage intersectionVolume(const LayeredDepthImage& a, const LayeredDepthImage& b);

// Sum of the intervals times a pixel's area, m^3.
double volume(const LayeredDepthImage& image);

}  // namespace resect
