// A label image as a model: a closed surface for each label.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/progress.h"
#include "formats/images/label_image.h"
#include "io/model.h"

namespace resect {

// Index in image.labels of the label that `name` means. `name` is the label's name, in upper or
// lower case; or its number, as in "5" or "label 5"; or, if no label of the image has a name, the
// name that TotalSegmentator gives to its number. Throws Error, which lists the labels, if there is
// no such label.
int labelNamed(const std::string& path, const LabelImage& image, const std::string& name);

// In labelModel(), a line of `parts` that begins with this prefix adds its label only where that
// label lies within the labels of the other lines (formats/labels/enclosed_voxels.h). It is meant
// for vessels, whose trunks reach out of the organ.
inline constexpr std::string_view kWithin = "within ";

// The first names, at most `most`, in the form "a, b, c and 9 more".
std::string nameList(const std::vector<std::string>& names, std::size_t most = 40);

// The names of the first 40 labels with their numbers, for messages: "5 liver, 7 pancreas and 3
// more".
std::string labelList(const LabelImage& image);

// If `parts` is empty, the model has a part for each label, with its name. Otherwise it has one
// part, whose name is `parts`: the surface round the union of the labels that the lines of `parts`
// name. If the image has a single label without a name, that label gets the name of the file.
// Throws Error if nothing is labelled.
Model labelModel(const std::string& path, const LabelImage& image, const std::string& parts,
                 const Progress& progress = {});

// "liver" for "/scans/liver.nii.gz".
std::string stemOf(const std::string& path);

}  // namespace resect
