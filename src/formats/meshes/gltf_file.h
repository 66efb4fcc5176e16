// Reads .glb and .gltf files (glTF 2.0).
//
// The Open Asset Import Library (assimp) does the reading, in single precision. For untrusted files
// call readModel() (inventor/reading/model_file.h) instead, which reads in a child process.
#pragma once

#include <string>
#include <string_view>

#include "formats/beside_files.h"
#include "formats/meshes/gltf_buffers.h"
#include "io/model.h"

namespace resect {

// The parts of the result are the file's nodes, in the order of the file, with transforms applied.
// Polygons become triangles; points and lines are left out. Numbers are taken as metres. `bytes`:
// content of the file, decompressed. `path`: for messages only. Opens no file. Throws Error if the
// file requires an extension that changes shapes and is not supported
// (formats/meshes/gltf_requirements.h); LacksFile if it needs a buffer that is not in `beside`.
Model readGltfFile(const std::string& path, std::string_view bytes, const BesideFiles& beside = {});

}  // namespace resect
