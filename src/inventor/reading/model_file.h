// Reads model files of any format safely. Files from outside are read by these functions only.
#pragma once

#include <filesystem>

#include "base/progress.h"
#include "io/model.h"

namespace resect {

// Reads .iv and .wrl (any Inventor or VRML), .obj .stl .ply .off .glb .gltf and legacy .vtk, each
// also gzip-compressed. The format is recognised by the first bytes if possible, else by the name.
// The model is in metres: Units nodes of Inventor are followed; numbers of other formats are taken
// as metres.
//
// A child process (formats/child_process.h) reads the file, with 2 GB of memory and 5 s of
// processor time plus 1 s for each MB of the file. If a file crashes or stalls its reader, an Error
// is thrown. Files over 1 GB are refused.
Model readModel(const std::filesystem::path& path);

// The same with progress: reports the fraction of an Inventor or VRML file that is read, and -1
// during the reading of other formats. Cancelling kills the child.
Model readModelWatched(const std::filesystem::path& path, const Progress& progress);

// The same with `seconds` > 0 of processor time instead of 5.
Model readModelWithin(const std::filesystem::path& path, double seconds,
                      const Progress& progress = {});

}  // namespace resect
