// The smooth closed surface round labels of an image.
//
// Marching cubes of the labels give a surface with steps of the size of voxels. The steps are
// smoothed within the precision of the image: each point moves at most half a voxel along each axis
// of the image (after Gibson 1998, 10.1007/BFb0056277). Each coordinate is smoothed by itself, more
// widely along an axis with longer voxels, so that thick slices leave no steps. Smoothing alone
// would shrink curved parts; so the displacement of the points by smoothing is itself smoothed, and
// subtracted (twicing, Tukey 1977). At the end the surface is moved along its normals until its
// volume equals that of the voxels.
#pragma once

#include <cstdint>
#include <span>

#include "formats/images/label_image.h"
#include "geometry/triangle_mesh.h"

namespace resect {

// The surface round the union of the chosen labels. chosen: indices in image.labels. The mesh is in
// the image's coordinates, m; closed, oriented outwards; where the voxels reach the border of the
// image, it is closed by a flat face. Empty if no label is chosen.
TriangleMesh labelSurface(const LabelImage& image, std::span<const int> chosen);

}  // namespace resect
