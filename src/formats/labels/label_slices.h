// Three orthogonal slices through a label image, in the orientation that radiologists use.
#pragma once

#include <string>
#include <vector>

#include "formats/images/label_image.h"
#include "formats/png_file.h"

namespace resect {

// Where slices lie, in the image's coordinates, m.
struct SliceFrame {
  // The projection of `centre` onto a slice is the middle of the slice's picture.
  Vec3 centre = Vec3::Zero();
  Vec3 middle = Vec3::Zero();  // the point in which the three slices meet
  double side = 0;             // width and height of each picture; 0 if no voxel is labelled
};

// The slices pass through the centroid of the parenchyma. If no label has a name that means
// parenchyma, they pass through the centroid of the largest label. Each slice is large enough to
// contain all labels.
SliceFrame sliceFrame(const LabelImage& image);

// Draws the three slices side by side. The first slice is axial and seen from below, so the
// patient's right is on the left. The second slice is coronal and seen from the front. The third
// slice is sagittal and seen from the patient's left. height: height of the picture, pixels, > 0.
// The name of a label tells the kind of its structure (anatomy/structure_kind.h), and each kind has
// a fixed colour. If the name tells no kind, the colour depends on the label's place in
// image.labels. name: stands in for the name of a label without a name. Unlabelled voxels are
// black.
RgbImage labelSlices(const LabelImage& image, const SliceFrame& frame, int height,
                     const std::string& name = {});

// Draws the slices of several files, which must have the same coordinate system, into one picture.
// All files are drawn in the SliceFrame of the first file. Later files are drawn over earlier
// files. A sandboxed child process reads each file. The picture is empty if no voxel of the first
// file is labelled.
RgbImage readLabelSlices(const std::vector<std::string>& files, int height);

}  // namespace resect
