// Reads label images in NRRD files (.nrrd, .seg.nrrd, .nhdr with a file of voxels).
//
// Source: "Definition of NRRD File Format" (teem.sourceforge.net/nrrd/format.html); segments as 3D
// Slicer writes them (keys Segment0_Name, Segment0_LabelValue, Segment0_Layer). Encodings raw, gzip
// and text.
#pragma once

#include <string>
#include <string_view>

#include "formats/beside_files.h"
#include "formats/images/label_image.h"

namespace resect {

bool startsAsNrrd(std::string_view bytes);

// Without a space the axes are taken as left, posterior, superior, in mm. Throws Error if the image
// is none of labels, or uses what is not read; LacksFile if its voxels are in a file of their own.
LabelImage readNrrdFile(const std::string& path, std::string_view bytes,
                        const BesideFiles& beside = {});

}  // namespace resect
