// Reads model files of any format safely: the only entry for files from outside.
#pragma once

#include <filesystem>

#include "base/progress.h"
#include "io/model.h"

namespace resect {

// Reads .iv and .wrl (any Inventor or VRML), .obj .stl .ply .off .glb .gltf and legacy .vtk, each
// also gzip-compressed. The format is recognised by the first bytes if possible, else by the name.
// In metres: Units nodes of Inventor are followed, other formats' numbers are taken as metres.
//
// The work is done in a child process (formats/child_process.h) with 2 GB of memory and 5 s of
// computing plus 1 s for each MB of the file; a file that crashes or stalls its reader becomes an
// Error. Files over 1 GB are refused.
Model readModel(const std::filesystem::path& path);

// The same with progress: the fraction of an Inventor or VRML file that is read, -1 for other
// formats. Cancelling kills the child.
Model readModelWatched(const std::filesystem::path& path, const Progress& progress);

// The same with `seconds` > 0 of computing instead of 5.
Model readModelWithin(const std::filesystem::path& path, double seconds,
                      const Progress& progress = {});

}  // namespace resect
