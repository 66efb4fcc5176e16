// Three slices through a label image, as a radiologist looks at them.
#pragma once

#include <string>
#include <vector>

#include "formats/images/label_image.h"
#include "formats/png_file.h"

namespace resect {

// Where slices lie, in the image's coordinates, m.
struct SliceFrame {
  Vec3 centre = Vec3::Zero();  // of each picture
  Vec3 middle = Vec3::Zero();  // where the slices meet
  double side = 0;             // width and height of each; 0: nothing is labelled
};

// Through the middle of the parenchyma, or of the largest label if no name tells it, and as large
// as all labels need.
SliceFrame sliceFrame(const LabelImage& image);

// Beside each other: from below (the patient's right is on the left), from the front, and from the
// left; `height` pixels high, > 0. Colours tell kinds of structures; labels without a kind have
// colours of their own. Black where nothing is labelled. `name`: of a label without a name.
RgbImage labelSlices(const LabelImage& image, const SliceFrame& frame, int height,
                     const std::string& name = {});

// The same of files in the same coordinates, later ones over earlier ones; in the frame of the
// first. A sandboxed child process reads each. Empty if nothing is labelled in the first.
RgbImage readLabelSlices(const std::vector<std::string>& files, int height);

}  // namespace resect
