// Files that a model or image refers to and that lie beside it: the buffers of a .gltf, the voxels
// of an image whose header is a file of its own.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "base/raw_array.h"

namespace resect {

// Content of the files. Key: the name as the referring file gives it, for a .gltf with codes such
// as %20 decoded.
using BesideFiles = std::map<std::string, RawArray<char>>;

// Thrown by a reader that needs a file that is not in its BesideFiles.
struct LacksFile {
  // The key that is missing. It comes from the file and may lead to any folder, so check it before
  // use.
  std::string name;
};

// For each file that may refer to others, appends all files in its folder that it may refer to.
// Which of them it uses is not known here, since only a reader in its sandbox parses it.
void addFilesBeside(std::vector<std::filesystem::path>& files);

// Whether a file of this name may be one that the file at `path` refers to, by the endings of both.
bool mayReferTo(const std::filesystem::path& path, const std::filesystem::path& name);

// Whether the name is one that files of voxels have: .raw, .zraw, .img, or .gz after another.
bool isVoxelFile(const std::filesystem::path& name);

}  // namespace resect
