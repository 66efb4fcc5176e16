// Reads .glb and .gltf files (glTF 2.0).
//
// The Open Asset Import Library (assimp) reads the numbers, in single precision. For untrusted
// files call readModel() (inventor/reading/model_file.h) instead: it reads them in a sandboxed
// child process.
#pragma once

#include <string>
#include <string_view>

#include "formats/beside_files.h"
#include "formats/meshes/gltf_buffers.h"
#include "io/model.h"

namespace resect {

// Each node of the file becomes a part of the model, in the order of the file. The transforms of
// the nodes are applied. Polygons become triangles. Points and lines are left out. Coordinates are
// taken as metres. path: for messages only; no file is opened. bytes: content of the file,
// decompressed. beside: contents of the buffer files that the file refers to. Throws Error if the
// file is damaged, or if it requires an extension that is not supported
// (formats/meshes/gltf_requirements.h). Throws LacksFile (formats/beside_files.h) if the file needs
// a buffer file that is not in `beside`.
Model readGltfFile(const std::string& path, std::string_view bytes, const BesideFiles& beside = {});

}  // namespace resect
