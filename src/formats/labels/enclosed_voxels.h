// Finds the parts of vessels that lie inside an organ, as opposed to the parts that lead to the
// organ.
#pragma once

#include <span>

#include "formats/images/label_image.h"

namespace resect {

// Returns the image with the first label of `organ` in those voxels of vessels that lie inside the
// organ. A voxel is enclosed along an axis if in both directions a voxel of the organ lies within
// 25 mm. A voxel is inside if it is enclosed along at least two of the three axes. Two axes are
// enough, so that a straight vein along the third axis is inside, too. organ, vessels: indices in
// image.labels, not empty.
LabelImage withEnclosed(LabelImage image, std::span<const int> organ, std::span<const int> vessels);

}  // namespace resect
