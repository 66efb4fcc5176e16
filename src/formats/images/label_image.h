// Label images: images made from a scan of a patient. The number in each voxel (its label) says to
// which organ the voxel belongs. An image may have several layers, for labels that overlap.
//
// Coordinates are the same as in DICOM, but in metres: x to the patient's left, y to the back, z to
// the head ("LPS").
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/raw_array.h"
#include "base/vec.h"

namespace resect {

inline constexpr std::int64_t kMostVoxels = std::int64_t(1) << 28;  // of an image
// Most bytes of an image's voxels after unpacking.
inline constexpr std::size_t kMostImageBytes = std::size_t(1) << 30;
inline constexpr double kImageSeconds = 60;  // most processor time for reading one image, s
inline constexpr int kMostLabels = 1000;     // of an image
inline constexpr int kMostLayers = 64;       // of an image

struct ImageLabel {
  std::int64_t value = 0;   // number in the file, not 0
  std::string name;         // may be empty
  int layer = 0;            // index in LabelImage::layers
  std::int64_t voxels = 0;  // number of voxels with this label
};

struct LabelImage {
  std::string format;          // for example "NIfTI-1"
  Vec3i dims = Vec3i::Zero();  // voxels along each axis, > 0
  Vec3 origin = Vec3::Zero();  // centre of the first voxel, m
  // Column a is the vector from a voxel to the next voxel along axis a, m.
  Mat3 step = Mat3::Identity();
  // A layer has one number per voxel, the first axis fastest: 0 if the voxel has no label,
  // otherwise 1 + the label's index in `labels`. Labels that overlap are in different layers.
  std::vector<RawArray<std::uint16_t>> layers;
  std::vector<ImageLabel> labels;  // each label has at least one voxel
  // Whether the program that wrote the file may have left out slices without labels. The missing
  // slices lie before the first or after the last slice of the file, along the third axis.
  bool slicesLeftOut = false;

  std::int64_t voxelCount() const { return std::int64_t(dims.x()) * dims.y() * dims.z(); }
  double voxelVolume() const { return std::abs(step.determinant()); }  // m^3
  Vec3 spacing() const { return step.colwise().norm(); }               // m
};

// Names of programs that make a label image from a scan, for messages.
inline constexpr const char* kLabelMakers = "TotalSegmentator, 3D Slicer or ITK-SNAP";

// Converts coordinates of NIfTI ("RAS": x to the patient's right, y to the front) to LPS, and back.
inline Vec3 turnedRasLps(const Vec3& p) { return {-p.x(), -p.y(), p.z()}; }

// Throws Error unless `dims` and `step` meet these conditions: there are 1 to kMostVoxels voxels;
// the spacing along each axis is 1 um to 1 m; the axes do not lie in one plane. `path`: for the
// message.
void checkGrid(const std::string& path, const LabelImage& image);

// orientation(): for each axis of the image the nearest direction of the body, as a letter: L left,
// R right, P back (posterior), A front (anterior), S head (superior), I feet (inferior); for
// example "LPS". obliqueness(): the largest angle between an axis of the image and its nearest
// direction of the body, degrees.
std::string orientation(const LabelImage& image);
double obliqueness(const LabelImage& image);

// A line such as "NIfTI-1 label image, 512 x 512 x 90 voxels of 0.8 x 0.8 x 5 mm, axes LPS"
std::string description(const LabelImage& image);

// The label's name, or "label 5" if it has none.
std::string shownName(const ImageLabel& label);

}  // namespace resect
