// What the headers of label images have in common: words, numbers, and files of voxels beside them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/vec.h"
#include "formats/beside_files.h"
#include "formats/images/voxel_values.h"

namespace resect {

std::vector<std::string> words(std::string_view text);  // parted by blanks

// "1, 0.5, 2" or "1 0.5 2". Throws Error if these are not three finite numbers.
Vec3 threeNumbers(const std::string& path, std::string_view text);

// The bytes that numbers written as text would have in a file of this type, little-endian.
std::string numbersFromText(const std::string& path, std::string_view text, VoxelType type);

// The file of voxels that a header names. Throws Error unless isVoxelFile(name); LacksFile if it is
// not in `beside`.
std::string_view besideVoxels(const std::string& path, const std::string& name,
                              const BesideFiles& beside);

}  // namespace resect
