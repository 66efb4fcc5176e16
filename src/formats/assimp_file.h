// Reads .obj, .stl, .ply, .off, .glb and .gltf files.
//
// Read with the Open Asset Import Library, in single precision. Untrusted files: call it through
// readModel (inventor/reading/model_file.h), which does it in a child process.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "base/raw_array.h"
#include "io/model.h"

namespace resect {

// Whether the file can be read here, by its extension.
bool isAssimpFile(const std::filesystem::path& path);

// Buffers of a .gltf that are files of their own, by the names that it calls them.
using BesideFiles = std::map<std::string, RawArray<char>>;

// Thrown by readAssimpFile when a .gltf needs a buffer that it was not given.
struct LacksFile {
  std::string name;  // as the file calls it: not checked
};

// Parts are the file's nodes (.glb, .gltf) or objects and groups (.obj), in their order, transforms
// applied; polygons become triangles, points and lines are left out. Numbers are taken as metres.
// `bytes`: content of the file, decompressed; `formatName`: a name with the format's extension;
// `path`: for messages only. Opens no file.
Model readAssimpFile(const std::filesystem::path& path, const std::filesystem::path& formatName,
                     std::string_view bytes, const BesideFiles& beside = {});

}  // namespace resect
