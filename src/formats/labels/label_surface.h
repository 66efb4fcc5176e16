// The smooth closed surface round labels of an image.
//
// Marching cubes of the labels give steps of voxels. These are smoothed as far as the image leaves
// it open where the border runs: each point may move half a voxel along each axis of the image
// (after Gibson 1998, 10.1007/BFb0056277). Each coordinate is smoothed by itself, wider along an
// axis with longer voxels, so that thick slices leave no terraces. Smoothing alone would shrink
// curved parts; what it took away is smoothed, too, and given back (twicing, Tukey 1977). At the
// end the surface is moved along its normals until it encloses as much as the voxels
// have.
#pragma once

#include <cstdint>
#include <span>

#include "formats/images/label_image.h"
#include "geometry/triangle_mesh.h"

namespace resect {

// chosen: indices in image.labels, whose voxels are taken together. The mesh is in the image's
// coordinates, m; closed, oriented outwards; closed flat where the voxels reach the border of the
// image. Empty if no label is chosen.
TriangleMesh labelSurface(const LabelImage& image, std::span<const int> chosen);

}  // namespace resect
