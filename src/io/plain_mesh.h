// Reads meshes that Resect wrote itself, without a reader of other programs' files.
#pragma once

#include <filesystem>

#include "io/model.h"

namespace resect {

// A surface in the .ply form of writeMeshFile (io/mesh_file.h): little endian, doubles, triangles,
// metres. For a file with another extension the .ply of the same name beside it is read: so
// instruments, which are drawn from .iv files, can be simulated without Inventor. A ModelReader
// (io/operation_setup.h). Cost: one pass. Throws Error if there is no such file, or it has another
// form or is truncated.
Model readPlainMesh(const std::filesystem::path& path);

}  // namespace resect
