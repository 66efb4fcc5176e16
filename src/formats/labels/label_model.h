// A label image as a model: a closed surface for each label.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/progress.h"
#include "formats/images/label_image.h"
#include "io/model.h"

namespace resect {

// Index in image.labels of the label that is called so: by name in any case, by number, as "label
// 5", or by the name of TotalSegmentator in an image without names. Throws Error if there is none,
// with the labels that there are.
int labelNamed(const std::string& path, const LabelImage& image, const std::string& name);

// What a line of `parts` begins with if its label counts only where it lies within the others
// (formats/labels/enclosed_voxels.h), as vessels do, whose trunks reach out of an organ.
inline constexpr std::string_view kWithin = "within ";

// The first names, at most `most`, as "a, b, c and 9 more".
std::string nameList(const std::vector<std::string>& names, std::size_t most = 40);

// The names of the first labels with their numbers, for messages: "5 liver, 7 pancreas and 3 more".
std::string labelList(const LabelImage& image);

// If `parts` is empty, the model has a part for each label, with its name. Otherwise it has one
// part, whose name is `parts`: the surface round all labels that `parts` names, a line each, taken
// together. An image of a single label without a name gives it the name of the file. Throws
// Error if nothing is labelled.
Model labelModel(const std::string& path, const LabelImage& image, const std::string& parts,
                 const Progress& progress = {});

// "liver" for "/scans/liver.nii.gz".
std::string stemOf(const std::string& path);

}  // namespace resect
