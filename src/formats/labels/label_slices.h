// Three orthogonal slices through a label image, in the orientation that radiologists use.
#pragma once

#include <string>
#include <vector>

#include "formats/images/label_image.h"
#include "formats/png_file.h"

namespace resect {

// Where slices lie, in the image's coordinates, m.
struct SliceFrame {
  Vec3 centre = Vec3::Zero();  // the middle of each picture is this point, projected onto the slice
  Vec3 middle = Vec3::Zero();  // the point in which the three slices meet
  double side = 0;             // width and height of each picture; 0: nothing is labelled
};

// The slices pass through the centroid of the parenchyma, or of the largest label if no name means
// parenchyma. Each slice is large enough to contain all labels.
SliceFrame sliceFrame(const LabelImage& image);

// Draws the slices beside each other: axial seen from below (the patient's right is on the left),
// coronal seen from the front, and sagittal seen from the patient's left. height: pixels, > 0. Each
// kind of structure (anatomy/structure_kind.h) has a fixed colour; every other label has a colour
// of its own. Unlabelled voxels are black. name: decides the colour of labels without a name.
RgbImage labelSlices(const LabelImage& image, const SliceFrame& frame, int height,
                     const std::string& name = {});

// The same for several files in the same coordinates, in the SliceFrame of the first one. Later
// files are drawn over earlier ones. A sandboxed child process reads each file. The result is empty
// if nothing is labelled in the first file.
RgbImage readLabelSlices(const std::vector<std::string>& files, int height);

}  // namespace resect
