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
// Whether the bytes begin like a DICOM segmentation, according to the object class in the header.
// bytes: at least the first kDicomHead bytes of the file, or the whole file if it is shorter.
bool startsAsSegmentation(std::string_view bytes);
inline constexpr std::size_t kDicomHead = 512;

// Loads DCMTK's dictionary, which DCMTK would otherwise load at its first use. To be called in a
// child process before the process loses the right to open files.
void prepareDicom();

// Throws Error if the file is not a segmentation, has compressed frames, or has unevenly spaced
// slices. The Error says what to do. In a fractional segment, a voxel belongs to the segment if its
// fraction is at least a half. Slices are placed at the coordinates that the file gives for them.
// If all frames have the same position, the spacing between slices is the one that the file gives.
// If the file gives no spacing, it is the slice thickness.
LabelImage readDicomFile(const std::string& path, std::string_view bytes);

}  // namespace resect
