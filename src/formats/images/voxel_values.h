// Turns the numbers of an image file into labels.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "base/error.h"
#include "formats/images/label_image.h"

namespace resect {

enum class VoxelType : std::uint8_t { U8, I8, U16, I16, U32, I32, U64, I64, F32, F64 };

std::size_t bytesOf(VoxelType type);  // size of one number of this type

// Numbers of an image as they are stored in a file.
struct VoxelNumbers {
  std::string_view bytes;
  VoxelType type = VoxelType::U8;
  bool bigEndian = false;
  // Voxel i has the number with the index first + stride * i. The stride is > 1 for images whose
  // first axis is not an axis of space.
  std::int64_t stride = 1, first = 0;
  double slope = 1, intercept = 0;  // value = slope * number + intercept
};

// Appends a layer to the image, and appends the labels in this layer. image.dims must be set.
// names: the names of labels; key: the label's value. Throws Error if bytes are missing, or if the
// values cannot be labels. Values cannot be labels if there are fractions or negative values, or
// more than kMostLabels different values. They cannot be labels either if there are more than 20
// different values and most labelled voxels differ from the voxel before.
void addLayer(const std::string& path, LabelImage& image, const VoxelNumbers& numbers,
              const std::map<std::int64_t, std::string>& names);

// The Error for an image of grey values instead of labels. why: for example, "it has values such as
// 0.5".
Error notLabels(const std::string& path, const std::string& why);

}  // namespace resect
