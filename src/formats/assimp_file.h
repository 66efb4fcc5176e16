// Reads .obj, .stl, .ply, .off, .glb and .gltf files.
//
// Read with the Open Asset Import Library, in single precision. Untrusted files: call it through
// readModel (inventor/reading/model_file.h), which does it in a child process.
#pragma once

#include <filesystem>
#include <string_view>

#include "io/model.h"

namespace resect {

// Whether the file can be read here, by its extension.
bool isAssimpFile(const std::filesystem::path& path);

// Parts are the file's nodes (.glb, .gltf) or objects and groups (.obj), in their order, transforms
// applied; polygons become triangles, points and lines are left out. Numbers are taken as metres.
// `bytes`: content of the file, decompressed; `formatName`: a name with the format's extension;
// `path`: for messages and for files beside a .gltf.
Model readAssimpFile(const std::filesystem::path& path, const std::filesystem::path& formatName,
                     std::string_view bytes);

}  // namespace resect
