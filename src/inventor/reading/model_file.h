// What surfaces does a file hold, whatever its format, and whatever it might do to its reader?
//
// The one way in for files that people give us.
#pragma once

#include <filesystem>

#include "base/progress.h"
#include "io/model.h"

namespace resect {

// Reads .iv and .wrl (any Inventor or VRML), .obj .stl .ply .off .glb .gltf and legacy .vtk, each
// also gzip-compressed. The format is told by the first bytes where they tell it, else by the name.
// In metres: Units nodes of Inventor are followed, other formats' numbers are taken as metres.
//
// The work is done in a child process (formats/child_process.h) with 2 GB of memory and 5 s of
// computing plus 1 s for each MB of the file; a file that kills or stalls its reader becomes one
// Error sentence. Files over 1 GB are refused.
Model readModel(const std::filesystem::path& path);

// The same while somebody watches: `progress` gets shares of an Inventor or VRML file's numbers, -1
// for others. To cancel ends the child.
Model readModelWatched(const std::filesystem::path& path, const Progress& progress);

// The same with `seconds` > 0 instead of the 5 s.
Model readModelWithin(const std::filesystem::path& path, double seconds,
                      const Progress& progress = {});

}  // namespace resect
