// Reads .obj, .stl, .ply, .off, .glb and .gltf files.
//
// The Open Asset Import Library (assimp) does the reading, in single precision. For untrusted files
// call readModel() (inventor/reading/model_file.h) instead, which reads in a child process.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "base/raw_array.h"
#include "io/model.h"

namespace resect {

// Whether readAssimpFile() reads files with the extension of `path`.
bool isAssimpFile(const std::filesystem::path& path);

// Content of the buffers that a .gltf keeps in files of their own. Key: the file's name as the
// .gltf gives it, with codes such as %20 decoded.
using BesideFiles = std::map<std::string, RawArray<char>>;

// Thrown by readAssimpFile() when a .gltf needs a buffer file that is not in `beside`.
struct LacksFile {
  // The key that is missing. It comes from the file and may lead to any folder, so check it before
  // use.
  std::string name;
};

// The parts of the result are the file's nodes (.glb, .gltf) or its objects and groups (.obj), in
// the order of the file, with transforms applied. Polygons become triangles; points and lines are
// left out. Numbers are taken as metres. `bytes`: content of the file, decompressed. `formatName`:
// a file name whose extension gives the format. `path`: for messages only. Opens no file.
Model readAssimpFile(const std::filesystem::path& path, const std::filesystem::path& formatName,
                     std::string_view bytes, const BesideFiles& beside = {});

}  // namespace resect
