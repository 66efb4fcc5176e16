// Reads meshes that Resect wrote itself; needs no reader for other programs' formats.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "io/model.h"

namespace resect {

// Reads a .ply file of the form that writeMeshFile() (io/mesh_file.h) writes: little endian,
// doubles, triangles, metres. If `path` has another extension, the .ply of the same name beside it
// is read instead: instruments are drawn from .iv files, and this lets them be simulated without
// Inventor. The function is a ModelReader (io/operation_setup.h). Cost: one pass. Throws Error if
// there is no such file, or if it has another form or is truncated.
Model readPlainMesh(const std::filesystem::path& path);
// The same from the file's bytes; `name` stands for the file in Errors.
Model parsePlainMesh(std::string_view bytes, const std::string& name);

}  // namespace resect
