// Finds the parts of vessels that lie inside an organ, as opposed to the parts that lead to the
// organ.
#pragma once

#include <span>

#include "formats/images/label_image.h"

namespace resect {

// Returns the image in which the voxels of vessels that lie inside the organ have the first label
// of `organ`. A voxel is inside if this holds along at least two of the three axes: in both
// directions, a voxel of the organ lies within 25 mm. Two axes are enough, so that a straight vein
// along the third axis is inside, too. organ, vessels: indices in image.labels, not empty.
LabelImage withEnclosed(LabelImage image, std::span<const int> organ, std::span<const int> vessels);

}  // namespace resect
