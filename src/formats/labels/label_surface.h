// The smooth closed surface round labels of an image.
//
// First, marching cubes make a surface that has steps as large as voxels. Then the points of this
// surface are smoothed within the precision of the image: each point moves at most half a voxel
// along each axis of the image (after Gibson 1998, 10.1007/BFb0056277). The three coordinates are
// smoothed separately. If voxels are longer along one axis, the coordinate along that axis is
// smoothed more widely, so that thick slices leave no steps. Smoothing alone would shrink curved
// parts. To prevent this, the displacements that smoothing causes are smoothed as well, and then
// subtracted (twicing, Tukey 1977). At the end the surface is moved along its normals until it
// encloses the same volume as the voxels.
#pragma once

#include <cstdint>
#include <span>

#include "formats/images/label_image.h"
#include "geometry/triangle_mesh.h"

namespace resect {

// The surface round the union of the chosen labels. chosen: indices in image.labels. The mesh has
// the image's coordinates, m. It is closed and oriented outwards. Where the chosen voxels reach the
// border of the image, a flat face closes the mesh. The mesh is empty if no label is chosen.
TriangleMesh labelSurface(const LabelImage& image, std::span<const int> chosen);

}  // namespace resect
