// Separates the parts of vessels inside an organ from those that lead to it.
#pragma once

#include <span>

#include "formats/images/label_image.h"

namespace resect {

// Returns the image in which the vessels' voxels inside the organ have the organ's first label. A
// voxel is inside if, along at least two of the three axes, voxels of the organ lie within 25 mm in
// both directions. So a straight vein that runs along an axis is inside too. organ, vessels:
// indices in image.labels, not empty.
LabelImage withEnclosed(LabelImage image, std::span<const int> organ, std::span<const int> vessels);

}  // namespace resect
