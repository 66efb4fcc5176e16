// Reads model files of all supported formats safely. Untrusted model files must be read by these
// functions only.
#pragma once

#include <filesystem>
#include <string>

#include "base/progress.h"
#include "io/model.h"

namespace resect {

// Reads surfaces from .iv and .wrl files (any version of Inventor or VRML) and from .obj, .stl,
// .ply, .off, .glb, .gltf, .3mf and legacy .vtk files. Also reads label images, in which each voxel
// has the number of the structure that it belongs to. Their formats are NIfTI, NRRD, MetaImage and
// DICOM segmentation. Every file may be gzip-compressed. The format is recognised by the first
// bytes if possible, otherwise by the extension (formats/model_kind.h). The model is in metres. To
// get metres, Units nodes of Inventor files are applied, .3mf files are converted from their unit,
// and images are converted from millimetres. All other coordinates are taken as metres.
//
// parts: names of the needed parts, as in a call of a ModelReader (io/operation_setup.h). The
// argument has an effect only for label images (labelModel() in formats/labels/label_model.h).
//
// A sandboxed child process (formats/child/foreign_reading.h) reads the file. The process may use 2
// GB of memory. Its processor time is limited to 5 s (60 s for an image), plus 1 s for each MB that
// is read. Throws Error if the process crashes or exceeds a limit. Also throws Error if the file
// and the files that it refers to are together larger than 1 GB.
Model readModel(const std::filesystem::path& path, const std::string& parts = {});

// The same with progress reports. While the file is read, `progress` gets a number that depends on
// the format. For an Inventor or VRML file it is the fraction of the file that has been read. For a
// label image it is -1 at first, and later the fraction of the model that has been made. For all
// other formats it is always -1. At the end `progress` gets 1. If `progress` cancels the reading,
// the child process is killed.
Model readModelWatched(const std::filesystem::path& path, const Progress& progress,
                       const std::string& parts = {});

// The same with another limit of processor time. seconds: replaces the 5 s of readModel(); > 0. For
// an image the limit is at least 60 s. In all cases 1 s is added for each MB that is read.
Model readModelWithin(const std::filesystem::path& path, double seconds,
                      const Progress& progress = {}, const std::string& parts = {});

}  // namespace resect
