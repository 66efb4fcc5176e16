// Files in the same folder that a model or image refers to: the buffers of a .gltf, or the voxels
// of an image whose header is a separate file.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "base/raw_array.h"

namespace resect {

// Content of these files, by name. The name is the one in the referring file; in a .gltf, codes
// such as %20 are decoded.
using BesideFiles = std::map<std::string, RawArray<char>>;

// Thrown by a reader that needs a file that is not in its BesideFiles.
struct LacksFile {
  // The key that is missing. It comes from the file and may lead to any folder, so check it before
  // use.
  std::string name;
};

// For each file that may refer to others, appends all files in its folder that it may refer to.
// Only a reader in its sandbox parses the file, so this function cannot know which of them it uses.
void addFilesBeside(std::vector<std::filesystem::path>& files);

// Whether the file at `path` may refer to a file with this name. Only the extensions of both are
// compared.
bool mayReferTo(const std::filesystem::path& path, const std::filesystem::path& name);

// Whether a file with this name may hold voxels: its extension is .raw, .zraw, .img or .gz.
bool isVoxelFile(const std::filesystem::path& name);

}  // namespace resect
