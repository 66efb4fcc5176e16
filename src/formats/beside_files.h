// Files that a model or an image refers to. They lie in the same folder as the model or image.
// Examples are the buffers of a .gltf file, and the voxels of an image whose header is a separate
// file.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "base/raw_array.h"

namespace resect {

// Content of these files, by name. The name is spelled as in the referring file, but codes such as
// %20 in a .gltf file are decoded.
using BesideFiles = std::map<std::string, RawArray<char>>;

// A reader throws this if it needs a file that its BesideFiles do not contain.
struct LacksFile {
  // The name of the missing file. The name comes from a foreign file and may lead to any folder, so
  // check it before use.
  std::string name;
};

// Some of `files` may refer to other files (.gltf, .hdr, .nhdr, .mhd). For each such file, appends
// all files of the same folder to which it may refer. No file is opened here, since only a
// sandboxed reader parses files. So some of the appended files may not be needed.
void addFilesBeside(std::vector<std::filesystem::path>& files);

// Whether the file at `path` may refer to a file with this name. Looks only at the extensions of
// the two names.
bool mayReferTo(const std::filesystem::path& path, const std::filesystem::path& name);

// Whether a file with this name may hold voxels: its extension is .raw, .zraw, .img or .gz.
bool isVoxelFile(const std::filesystem::path& name);

}  // namespace resect
