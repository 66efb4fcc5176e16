// How is a mesh read that Resect wrote itself, where no reader of other programs' files is linked?
#pragma once

#include <filesystem>

#include "io/model.h"

namespace resect {

// A surface in the .ply form of writeMeshFile (io/mesh_file.h): little endian, doubles, triangles,
// metres. Of a file with another ending the .ply of the same name beside it is read: so
// instruments, which are shown by .iv files, need no Inventor to be stepped. A ModelReader
// (io/operation_setup.h). Cost: one pass. Throws Error when there is no such file, or it has
// another form or is cut off.
Model readPlainMesh(const std::filesystem::path& path);

}  // namespace resect
