// The report of `resect info` about a label image.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "formats/labels/label_file.h"

namespace resect {

// A line for the image, and a line for each label. The line of a label gives its number, its name,
// its volume in ml, the role that the name implies, and whether the label reaches the border of the
// image.
std::string toText(const LabelFacts& facts, const std::string& path);

// The report as JSON with the fields {"file", "format", "labels": [{"value", "name", "voxels",
// "volume_ml", "kind", "cut_off"}]}
nlohmann::ordered_json toJson(const LabelFacts& facts, const std::string& path);

}  // namespace resect
