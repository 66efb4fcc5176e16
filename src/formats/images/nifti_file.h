// Reads label images in NIfTI files (.nii, .hdr with .img), versions 1 and 2.
//
// By a reader of our own: that of the format's authors (niftilib 3.0.1) overruns its stack on one
// damaged header in some ten thousand. Source: nifti.nimh.nih.gov, nifti1.h and nifti2.h.
#pragma once

#include <string>
#include <string_view>

#include "formats/beside_files.h"
#include "formats/images/label_image.h"

namespace resect {

bool startsAsNifti(std::string_view bytes);  // decompressed

// The orientation is that of the sform if it is set, else of the qform. Names of labels are read
// from an extension with a label table, as TotalSegmentator writes it. Throws Error if the image
// has several volumes or is none of labels; LacksFile if a .hdr needs its .img.
LabelImage readNiftiFile(const std::string& path, std::string_view bytes,
                         const BesideFiles& beside = {});

}  // namespace resect
