// Three slices through a label image, as a radiologist looks at them.
#pragma once

#include <filesystem>

#include "formats/images/label_image.h"
#include "formats/png_file.h"

namespace resect {

// Beside each other: from below (the patient's right is on the left), from the front, and from the
// left, through the middle of the parenchyma, or of the largest label if no name tells it. All at
// one scale, `height` pixels high, > 0. Colours tell kinds of structures; labels without a kind
// have colours of their own. Black where nothing is labelled.
RgbImage labelSlices(const LabelImage& image, int height);

// The same of a file, which a sandboxed child process reads.
RgbImage readLabelSlices(const std::filesystem::path& path, int height);

}  // namespace resect
