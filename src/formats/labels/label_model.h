// A label image as a model: a closed surface for each label.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/progress.h"
#include "formats/images/label_image.h"
#include "io/model.h"

namespace resect {

// Index in image.labels of the label that `name` means. `name` can be the label's name, in upper or
// lower case. It can also be the label's number, as in "5" or "label 5". If no label of the image
// has a name, it can also be the name that TotalSegmentator gives to the label's number
// (formats/labels/label_names.h). If there is no such label, throws an Error that lists the labels.
int labelNamed(const std::string& path, const LabelImage& image, const std::string& name);

// Prefix of a line of `parts` in labelModel(). The label in such a line is added only where it lies
// inside the labels of the lines without the prefix (formats/labels/enclosed_voxels.h). The prefix
// is meant for vessels, since their trunks reach out of the organ.
inline constexpr std::string_view kWithin = "within ";

// The first `most` names as one text, such as "a, b, c and 9 more".
std::string nameList(const std::vector<std::string>& names, std::size_t most = 40);

// The numbers and names of the first 40 labels, for messages, such as "5 liver, 7 pancreas and 3
// more".
std::string labelList(const LabelImage& image);

// If `parts` is empty, the model has one part for each label, and the part has the name of the
// label. Otherwise the model has a single part, and the name of this part is `parts`. This part is
// the surface round the union of the labels that the lines of `parts` name. If the image has only
// one label and this label has no name, the label gets the name of the file. Throws Error if no
// voxel is labelled.
Model labelModel(const std::string& path, const LabelImage& image, const std::string& parts,
                 const Progress& progress = {});

}  // namespace resect
