// Writes meshes to files that other programs read.
#pragma once

#include <filesystem>

#include "geometry/triangle_mesh.h"

namespace resect {

// Checks that writeMeshFile() can write to `path`. To be called before a long computation whose
// result is written to `path`. The extension must be .obj, .stl, .ply, .vtk or .iv, in upper or
// lower case. A device or pipe may also have no extension. Throws a usage Error for any other
// extension. Also throws the Errors of findTarget() (io/output/output_target.h).
void checkWritableMeshFile(const std::filesystem::path& path);

// Writes the mesh, atomically (io/output/atomic_file.h) and in metres. The extension decides the
// format. A device or pipe without an extension, such as /dev/stdout, gets the format .obj.
//  .obj  text; each coordinate has enough digits to restore the same double
//  .ply  binary, little-endian; exact, since coordinates are doubles
//  .vtk  legacy PolyData, binary, big-endian; exact, since coordinates are doubles
//  .iv   Inventor V2.1 ascii, an IndexedFaceSet; as many digits as in .obj, but Inventor reads
//        numbers with single precision
//  .stl  binary; this format has single precision and no shared points
// Any other extension is a usage Error.
void writeMeshFile(const std::filesystem::path& path, const TriangleMesh& mesh);

}  // namespace resect
