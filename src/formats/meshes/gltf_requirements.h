// Extensions of glTF that change a model's shape. Each is either refused with an Error that names
// it, or applied before the library (assimp) reads the file.
#pragma once

#include <string>
#include <string_view>

#include "formats/beside_files.h"
#include "formats/meshes/gltf_buffers.h"

namespace resect {

// A glTF file whose positions are all single-precision numbers.
struct PlainGltf {
  std::string bytes;      // the file; empty: the original file is plain already
  std::string positions;  // content of the buffer kPlainPositions that `bytes` refers to
};

// Contains a slash, so no file beside a model can have this name (formats/child/foreign_file.h).
inline constexpr const char* kPlainPositions = "resect/positions.bin";

// Checks the lengths in a .glb file, and reads the JSON of a .glb or .gltf file. Undoes
// KHR_mesh_quantization: integer positions become floats, and the other attributes of their
// primitives are left out. Extensions that change only the appearance are left to the library.
// Throws Error if the file is shorter than it says, if the JSON is damaged or if the file requires
// an extension that is not supported; LacksFile (formats/beside_files.h) if quantized positions lie
// in a buffer file that is not in `beside`.
PlainGltf plainGltf(const std::string& path, std::string_view bytes, const BesideFiles& beside);

}  // namespace resect
