// Buffer files beside .gltf models.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/raw_array.h"

namespace resect {

// Both functions look only at the name's extension, in upper or lower case. Buffers have the
// extension .bin, .glbin or .glbuf (glTF 2.0, "Implementation Note").
bool isGltf(const std::filesystem::path& name);
bool isGltfBuffer(const std::filesystem::path& name);

// For each .gltf file in `files`, appends all buffers in its folder, since its reader may be given
// any of them. Which of them the model uses is not known here, since only the reader in its sandbox
// parses models.
void addFilesOfGltf(std::vector<std::filesystem::path>& files);

// Content of the buffers that a .gltf keeps in files of their own. Key: the file's name as the
// .gltf gives it, with codes such as %20 decoded.
using BesideFiles = std::map<std::string, RawArray<char>>;

// Thrown by readGltfFile() when a .gltf needs a buffer file that is not in `beside`.
struct LacksFile {
  // The key that is missing. It comes from the file and may lead to any folder, so check it before
  // use.
  std::string name;
};

// "my%20buffer.bin" as "my buffer.bin" (RFC 3986, 2.1).
std::string withoutPercents(std::string_view text);

// Throws Error, about the model at `path`, unless isGltfBuffer(name).
void requireGltfBuffer(const std::string& path, const std::string& name);

}  // namespace resect
