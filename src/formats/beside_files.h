// Files that a model or image refers to and that lie in its folder: the buffers of a .gltf, or the
// voxels of an image whose header is a separate file.
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

// For each of `files` that may refer to others (.gltf, .hdr, .nhdr, .mhd), appends all files of its
// folder that it may refer to. The files are not opened here (only a sandboxed reader parses them),
// so some of the appended files may not be needed.
void addFilesBeside(std::vector<std::filesystem::path>& files);

// Whether the file at `path` may refer to a file with this name. Looks only at the extensions of
// the two names.
bool mayReferTo(const std::filesystem::path& path, const std::filesystem::path& name);

// Whether a file with this name may hold voxels: its extension is .raw, .zraw, .img or .gz.
bool isVoxelFile(const std::filesystem::path& name);

}  // namespace resect
