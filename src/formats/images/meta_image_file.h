// Reads label images in MetaImage files (.mha, or .mhd with a separate file of voxels).
//
// Source: "MetaIO" (itk.org/Wiki/MetaIO/Documentation). Coordinates in the file are left,
// posterior, superior, in mm, as ITK writes them.
#pragma once

#include <string>
#include <string_view>

#include "formats/beside_files.h"
#include "formats/images/label_image.h"

namespace resect {

// Whether the bytes begin with a line of a MetaImage's header.
bool startsAsMetaImage(std::string_view bytes);

// Throws Error if the image does not hold labels, or uses a feature that is not supported. Throws
// LacksFile if the image's voxels are in a separate file that `beside` does not contain.
LabelImage readMetaImageFile(const std::string& path, std::string_view bytes,
                             const BesideFiles& beside = {});

}  // namespace resect
