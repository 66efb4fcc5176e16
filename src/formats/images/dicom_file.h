// Reads DICOM segmentations (DICOM SEG).
//
// DCMTK parses the file. This code assembles the file's frames into an image. Source: DICOM PS3.3,
// A.51 and C.8.20.
#pragma once

#include <string>
#include <string_view>

#include "formats/images/label_image.h"

namespace resect {

// Whether the bytes begin like a DICOM file.
bool startsAsDicom(std::string_view bytes);
// Whether they begin like a DICOM segmentation, by the class of the object in the file's header.
// bytes: at least the first kDicomHead of the file, or all if it is shorter.
bool startsAsSegmentation(std::string_view bytes);
inline constexpr std::size_t kDicomHead = 512;

// Loads DCMTK's dictionary, which DCMTK would otherwise load at its first use. To be called in a
// child process before it loses the right to open files.
void prepareDicom();

// Throws Error, which says what to do, if the file is not a segmentation, has compressed frames or
// has unevenly spaced slices. In a fractional segment, voxels with a fraction of at least a half
// belong to the segment. The positions of the slices determine where they lie; the slice thickness
// in the file is ignored.
LabelImage readDicomFile(const std::string& path, std::string_view bytes);

}  // namespace resect
