// Reads .3mf files (3D Manufacturing Format, core specification 1.3). Programs for 3D printing
// write such files.
//
// The Open Asset Import Library (assimp) reads the numbers, in single precision. For untrusted
// files call readModel() (inventor/reading/model_file.h) instead: it reads them in a sandboxed
// child process.
#pragma once

#include <string>
#include <string_view>

#include "io/model.h"

namespace resect {

// Whether the bytes are a ZIP archive that holds a 3D model, as a .3mf file does.
bool isThreeMf(std::string_view bytes);

// Each object in the file's build section becomes a part of the model. The transforms of the
// objects are applied. Coordinates are converted to metres. If the file names no unit, its
// coordinates are taken as millimetres. path: for messages only. bytes: content of the file. Throws
// Error if the file is damaged. Also throws Error if the file requires an extension, since an
// extension may change the shape. Only the extension for materials is allowed.
Model readThreeMfFile(const std::string& path, std::string_view bytes);

}  // namespace resect
