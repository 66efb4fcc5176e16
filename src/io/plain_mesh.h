// Reads meshes that Resect wrote itself, without the readers for formats of other programs.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "io/model.h"

namespace resect {

// Reads a .ply file of the form that writeMeshFile() (io/mesh_file.h) writes: little endian,
// doubles, triangles, metres. If `path` has another extension, reads the .ply file with the same
// name beside it instead. So the instruments that come with Resect, whose models are .iv files, can
// be simulated without Inventor. The function is a ModelReader (io/operation_setup.h); it ignores
// `parts`. Cost: one pass. Throws Error if the .ply file does not exist, is truncated or has
// another form.
Model readPlainMesh(const std::filesystem::path& path, const std::string& parts = {});
// The same from the file's bytes; `name` stands for the file in Errors.
Model parsePlainMesh(std::string_view bytes, const std::string& name);

}  // namespace resect
