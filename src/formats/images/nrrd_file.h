// Reads label images in NRRD files (.nrrd, .seg.nrrd, or .nhdr with a separate file of voxels).
//
// Source: "Definition of NRRD File Format" (teem.sourceforge.net/nrrd/format.html). Names, values
// and layers of segments are read from the keys that 3D Slicer writes (Segment0_Name,
// Segment0_LabelValue, Segment0_Layer). Reads the encodings raw, gzip and text.
#pragma once

#include <string>
#include <string_view>

#include "formats/beside_files.h"
#include "formats/images/label_image.h"

namespace resect {

// Whether the bytes begin like an NRRD file.
bool startsAsNrrd(std::string_view bytes);

// If the header has no field `space`, coordinates are taken as left, posterior, superior, in mm.
// Throws Error if the image does not hold labels, or uses a feature that is not supported. Throws
// LacksFile if the image's voxels are in a separate file that `beside` does not contain.
LabelImage readNrrdFile(const std::string& path, std::string_view bytes,
                        const BesideFiles& beside = {});

}  // namespace resect
