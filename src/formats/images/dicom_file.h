// Reads DICOM segmentations (DICOM SEG).
//
// DCMTK parses the file; here its frames are put together to an image. Source: DICOM PS3.3, A.51
// and C.8.20.
#pragma once

#include <string>
#include <string_view>

#include "formats/images/label_image.h"

namespace resect {

bool startsAsDicom(std::string_view bytes);

// Loads DCMTK's dictionary, which it would do at its first use: for a child process that will not
// be able to open files.
void prepareDicom();

// A file of any other kind than a segmentation is an Error that says what to do, as are compressed
// frames and slices at uneven distances. Fractional segments are taken where they are at least a
// half. Slices lie as their positions say, never as their thickness.
LabelImage readDicomFile(const std::string& path, std::string_view bytes);

}  // namespace resect
