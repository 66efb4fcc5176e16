// Reads model files of all supported formats safely. Models from outside are read by these
// functions only.
#pragma once

#include <filesystem>
#include <string>

#include "base/progress.h"
#include "io/model.h"

namespace resect {

// Reads .iv and .wrl (any version of Inventor or VRML), .obj, .stl, .ply, .off, .glb, .gltf, .3mf
// and legacy .vtk; and label images: NIfTI, NRRD, MetaImage and DICOM segmentations. Each may be
// gzip-compressed. The format is recognised by the first bytes if possible, otherwise by the
// extension (formats/model_kind.h). The model is in metres: Inventor's Units nodes are applied, the
// millimetres of images are converted, and all other numbers are taken as metres.
//
// parts: as a ModelReader takes it (io/operation_setup.h). The argument has an effect only for
// label images (formats/labels/label_model.h).
//
// A child process (formats/child/foreign_reading.h) reads the file. It may use 2 GB of memory. Its
// processor time is limited to 5 s (60 s for an image), plus 1 s for each MB of the file. If the
// file makes it crash or exceed a limit, an Error is thrown. A file is refused if it and the files
// that it refers to have more than 1 GB in all.
Model readModel(const std::filesystem::path& path, const std::string& parts = {});

// The same with progress reports. For an Inventor or VRML file `progress` gets the fraction of the
// file that has been read; for other formats it gets -1 while the file is read. At the end it gets
// 1. Cancelling kills the child process.
Model readModelWatched(const std::filesystem::path& path, const Progress& progress,
                       const std::string& parts = {});

// The same with a limit of `seconds` > 0 of processor time instead of 5 s; for an image the limit
// is at least 60 s. In all cases 1 s for each MB of the file is added.
Model readModelWithin(const std::filesystem::path& path, double seconds,
                      const Progress& progress = {}, const std::string& parts = {});

}  // namespace resect
