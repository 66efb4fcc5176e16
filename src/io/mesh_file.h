// Writes meshes to files of other programs.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "geometry/triangle_mesh.h"

namespace resect {

// To be called before long work: a usage Error unless the name's extension can be written: .obj
// .stl .ply .vtk .iv (any case); else as checkTarget() (io/atomic_file.h).
void checkWritableMeshFile(const std::filesystem::path& path,
                           std::span<const std::string> inputs = {});

// Writes by the name's extension, atomically (io/atomic_file.h), in metres:
//   .obj  text, every coordinate with the digits that give back the same double
//   .ply  binary little-endian, doubles: exact
//   .vtk  legacy PolyData, binary big-endian, doubles: exact
//   .iv   Inventor V2.1 ascii, an IndexedFaceSet; digits as .obj, though Inventor keeps single
//         precision
//   .stl  binary; the format itself has single precision and no shared points
// An unknown extension is a usage Error.
void writeMeshFile(const std::filesystem::path& path, const TriangleMesh& mesh);

}  // namespace resect
