// Writes meshes to files that other programs read.
#pragma once

#include <filesystem>

#include "geometry/triangle_mesh.h"

namespace resect {

// Call before long work whose result goes to `path`. Throws a usage Error unless the extension is
// .obj, .stl, .ply, .vtk or .iv, in upper or lower case. Then calls findTarget()
// (io/output/output_target.h).
void checkWritableMeshFile(const std::filesystem::path& path);

// Writes the mesh, atomically (io/atomic_file.h) and in metres. The extension decides the format. A
// device or pipe without an extension, such as /dev/stdout, gets the format .obj.
//  .obj  text; each coordinate has enough digits to restore the same double
//  .ply  binary little-endian, doubles: exact
//  .vtk  legacy PolyData, binary big-endian, doubles: exact
//  .iv   Inventor V2.1 ascii, an IndexedFaceSet; digits as in .obj, though Inventor reads single
//        precision
//  .stl  binary; this format has single precision and no shared points
// Any other extension is a usage Error.
void writeMeshFile(const std::filesystem::path& path, const TriangleMesh& mesh);

}  // namespace resect
