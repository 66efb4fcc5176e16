// Reads .3mf files (3D Manufacturing Format, core specification 1.3), which programs for 3D
// printing write.
//
// The Open Asset Import Library (assimp) does the reading, in single precision. For untrusted files
// call readModel() (inventor/reading/model_file.h) instead, which reads in a child process.
#pragma once

#include <string>
#include <string_view>

#include "io/model.h"

namespace resect {

// Whether the bytes are a ZIP archive that holds a 3D model, as a .3mf file does.
bool isThreeMf(std::string_view bytes);

// The parts of the result are the objects that the file builds, with transforms applied, converted
// to metres from the unit that the file names, or from millimetres if it names none. bytes: content
// of the file. path: for messages only. Throws Error if the file requires an extension other than
// that of materials, since such an extension may change the shape.
Model readThreeMfFile(const std::string& path, std::string_view bytes);

}  // namespace resect
