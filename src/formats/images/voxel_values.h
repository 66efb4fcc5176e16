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

std::size_t bytesOf(VoxelType type);

// Numbers of an image as they stand in a file.
struct VoxelNumbers {
  std::string_view bytes;
  VoxelType type = VoxelType::U8;
  bool bigEndian = false;
  // Numbers between one voxel and the next, and number of the first voxel: for images whose first
  // axis is none of space.
  std::int64_t stride = 1, first = 0;
  double slope = 1, intercept = 0;  // value = slope * number + intercept
};

// Appends a layer to the image, whose dims are set, with the labels in it. `names`: by value.
// Throws Error if bytes are missing, or if these are no labels: values that are not whole, or more
// of them than kMostLabels, or neighbours that hardly ever agree.
void addLayer(const std::string& path, LabelImage& image, const VoxelNumbers& numbers,
              const std::map<std::int64_t, std::string>& names);

// The Error about an image of grey values. why: "it has values such as 0.5".
Error notLabels(const std::string& path, const std::string& why);

}  // namespace resect
