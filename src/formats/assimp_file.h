// Reads .obj, .stl, .ply, .off, .glb and .gltf files.
//
// The Open Asset Import Library (assimp) reads them, in single precision. Read untrusted files
// through readModel (inventor/reading/model_file.h), which does the work in a child process.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "base/raw_array.h"
#include "io/model.h"

namespace resect {

// Whether readAssimpFile() reads such files, judged by the extension.
bool isAssimpFile(const std::filesystem::path& path);

// Buffers of a .gltf that are files of their own, by the names that it calls them.
using BesideFiles = std::map<std::string, RawArray<char>>;

// Thrown by readAssimpFile when a .gltf needs a buffer that it was not given.
struct LacksFile {
  std::string name;  // as the file calls it: not checked
};

// Parts are the file's nodes (.glb, .gltf) or objects and groups (.obj), in their order, with
// transforms applied. Polygons become triangles; points and lines are left out. Numbers are taken
// as metres. `bytes`: content of the file, decompressed. `formatName`: a name with the format's
// extension. `path`: for messages. Opens no file.
Model readAssimpFile(const std::filesystem::path& path, const std::filesystem::path& formatName,
                     std::string_view bytes, const BesideFiles& beside = {});

}  // namespace resect
