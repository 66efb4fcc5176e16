// Functions for the headers of all label image formats: words, numbers, and separate files of
// voxels.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/vec.h"
#include "formats/beside_files.h"
#include "formats/images/voxel_values.h"

namespace resect {

std::vector<std::string> words(std::string_view text);  // split at spaces, tabs, line ends

// Reads "1, 0.5, 2" or "1 0.5 2". Throws Error if the text is not three finite numbers.
Vec3 threeNumbers(const std::string& path, std::string_view text);

// Converts numbers written as text to binary numbers of the type `type`, little-endian.
std::string numbersFromText(const std::string& path, std::string_view text, VoxelType type);

// The content of the file of voxels that a header names. Throws Error if isVoxelFile(name) is
// false. Throws LacksFile if `beside` does not contain the file.
std::string_view besideVoxels(const std::string& path, const std::string& name,
                              const BesideFiles& beside);

}  // namespace resect
