// Handles the extensions of glTF that change a model's shape. KHR_mesh_quantization is undone
// before the library (assimp) reads the file. If the file requires another extension that changes
// the shape, the file is refused with an Error that names the extension.
#pragma once

#include <string>
#include <string_view>

#include "formats/beside_files.h"
#include "formats/meshes/gltf_buffers.h"

namespace resect {

// A glTF file in which all positions are single-precision numbers.
struct PlainGltf {
  std::string bytes;      // the changed file; empty if the original needs no change
  std::string positions;  // content of the buffer file kPlainPositions, used by `bytes`
};

// Name by which PlainGltf::bytes refers to PlainGltf::positions. It contains a slash, so no file
// beside a model can have this name (formats/child/foreign_file.h).
inline constexpr const char* kPlainPositions = "resect/positions.bin";

// Checks the lengths in a .glb file, and reads the JSON of a .glb or .gltf file. Undoes
// KHR_mesh_quantization: integer positions become single-precision numbers. A primitive with such
// positions loses its other attributes. Extensions that change only the appearance are left to the
// library. Throws Error if the file is shorter than the lengths in it, if the JSON is damaged, or
// if the file requires an extension that is not supported. Throws LacksFile
// (formats/beside_files.h) if integer positions lie in a buffer file that is not in `beside`.
PlainGltf plainGltf(const std::string& path, std::string_view bytes, const BesideFiles& beside);

}  // namespace resect
