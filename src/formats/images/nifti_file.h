// Reads label images in NIfTI files (.nii, .hdr with .img), versions 1 and 2.
//
// Resect has its own reader, because the reader of the format's authors (niftilib 3.0.1) overruns
// its stack on about one damaged header in ten thousand. Source: nifti.nimh.nih.gov, nifti1.h and
// nifti2.h.
#pragma once

#include <string>
#include <string_view>

#include "formats/beside_files.h"
#include "formats/images/label_image.h"

namespace resect {

// Whether the bytes, which must be decompressed, begin like a NIfTI file.
bool startsAsNifti(std::string_view bytes);

// The orientation is taken from the sform if it is set, otherwise from the qform. Names of labels
// are read from an extension with a label table, as TotalSegmentator writes it. Throws Error if the
// image has several volumes or does not hold labels. Throws LacksFile if a .hdr file needs its .img
// file and `beside` does not contain it.
LabelImage readNiftiFile(const std::string& path, std::string_view bytes,
                         const BesideFiles& beside = {});

}  // namespace resect
