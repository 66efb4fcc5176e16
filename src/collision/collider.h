// How much of one closed body is in another, and where? In the three stages of the original thesis
// (2004, sections 2.2.1 and 4.3), each a function:
//
//     const Aabb common = intersection(bounds(organ), bounds(tool));         // volume of interest
//     const ColumnGrid pixels = pixelsOver(common, 64);
//     const LayeredDepthImage a = layeredDepthImage(organ, common, pixels);  // of each body
//     const LayeredDepthImage b = layeredDepthImage(tool, common, pixels);
//     const LayeredDepthImage both = intersectionVolume(a, b);               // common part
//     volume(both);
//
// Which single points are inside asks insideFlags(), and which a moving tool touches sweptInside()
// (collision/inside.h): exactly, not by the nearest pixel.
//
// A pixel is a column along z at the pixel's centre; it holds the stretches that lie inside,
// clipped to the volume of interest. Columns always run along z: the error of the volume shrinks
// with the pixels whatever the direction, and one raster per mesh serves every question. Source:
// Heidelberger, Teschner, Gross (2003).
#pragma once

#include <span>
#include <vector>

#include "collision/columns.h"

namespace resect {

// About square pixels over a box in x and y, `resolution` >= 1 of them along its longer side, their
// columns at their centres. None over a box that is empty or flat.
ColumnGrid pixelsOver(const Aabb& box, int resolution);

struct DepthInterval {
  double entry, exit;  // z, m; entry < exit
};

struct LayeredDepthImage {
  ColumnGrid pixels;
  std::vector<std::uint32_t> offsets{0};  // pixels + 1 entries
  std::vector<DepthInterval> intervals;
  // Pixels whose column enters the mesh more often than it leaves, or less: the mesh is open there.
  std::int64_t openPixels = 0;

  // Stretches of pixel j * pixels.countX + i, upwards; they do not touch each other.
  std::span<const DepthInterval> operator[](std::size_t pixel) const {
    return {intervals.data() + offsets[pixel], intervals.data() + offsets[pixel + 1]};
  }
};

// The inside of a closed, oriented, finite mesh in the box. wanted: one flag per pixel, or none for
// all; pixels that are not wanted stay empty, and the mesh need not be whole there. Cost: a pass
// over the mesh and the crossings.
LayeredDepthImage layeredDepthImage(const TriangleMesh& mesh, const Aabb& box,
                                    const ColumnGrid& pixels,
                                    std::span<const std::uint8_t> wanted = {});

// One flag per pixel: it holds something.
std::vector<std::uint8_t> coveredPixels(const LayeredDepthImage& image);

// Pixelwise common part of two images of the same box and pixels.
LayeredDepthImage intersectionVolume(const LayeredDepthImage& a, const LayeredDepthImage& b);

// Sum of the stretches times a pixel's area, m^3.
double volume(const LayeredDepthImage& image);

}  // namespace resect
