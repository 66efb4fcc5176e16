// Which surfaces does a .obj, .stl, .ply, .off, .glb or .gltf file hold?
//
// Read with the Open Asset Import Library, in single precision. Untrusted files: call it through
// readModel (inventor/reading/model_file.h), which does it in a child process.
#pragma once

#include <filesystem>
#include <string_view>

#include "io/model.h"

namespace resect {

// Can the file be read here, by its name?
bool isAssimpFile(const std::filesystem::path& path);

// Parts are the file's nodes (.glb, .gltf) or objects and groups (.obj), in their order, transforms
// applied; polygons become triangles, points and lines are left out. Metres, whatever the file
// means by its numbers. `bytes` is what the file holds, no longer compressed; `formatName` ends as
// its format does; `path` is for messages and for what a .gltf keeps beside it.
Model readAssimpFile(const std::filesystem::path& path, const std::filesystem::path& formatName,
                     std::string_view bytes);

}  // namespace resect
