// Reads meshes that Resect itself has written. The readers for other programs' formats are not
// needed for this.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "io/model.h"

namespace resect {

// Reads a .ply file of the form that writeMeshFile() (io/mesh_file.h) writes: little endian,
// doubles, triangles, metres. If `path` has another extension, reads the .ply file that has the
// same name in the same folder. The model of each instrument that comes with Resect is an .iv file,
// and a .ply file of the same name lies beside it. So these instruments can be simulated without
// Inventor. The function is a ModelReader (io/operation_setup.h); it ignores `parts`. Cost: one
// pass over the bytes. Throws Error if the .ply file does not exist, is truncated or has another
// form.
Model readPlainMesh(const std::filesystem::path& path, const std::string& parts = {});
// Does the same with the bytes of a file. Errors use `name` as the file's name.
Model parsePlainMesh(std::string_view bytes, const std::string& name);

}  // namespace resect
