// Vessels within an organ, parted from those that lead to it.
#pragma once

#include <span>

#include "formats/images/label_image.h"

namespace resect {

// The image, with the voxels of the labels `vessels` that lie within the labels `organ` given to
// the first of these: from such a voxel the organ, or another vessel within it, is met within 25 mm
// in at least five of the six directions of the axes. Both are indices in image.labels, and not
// empty.
LabelImage withEnclosed(LabelImage image, std::span<const int> organ, std::span<const int> vessels);

}  // namespace resect
