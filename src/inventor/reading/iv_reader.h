// Reads the surfaces of Inventor and VRML files with the library Coin.
//
// The formats are Inventor V1.0 to V2.1 (ascii and binary), VRML 1.0 and VRML 97. For untrusted
// files call readModel() (inventor/reading/model_file.h) instead: it reads them in a sandboxed
// child process.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "inventor/reading/scene_model.h"
#include "io/model.h"

namespace resect {

// path: for messages only. bytes: content of the file, decompressed. reading: which code converts
// shapes to triangles (inventor/reading/scene_model.h). tell: called after every 10 000 numbers,
// with the fraction of the bytes that has been read. If Coin reports a read error, throws an Error
// with the number of the line, since Coin then returns only a part of the scene. There is no Error
// for a texture that cannot be read. The function is not thread-safe.
Model readInventorFile(const std::string& path, std::string_view bytes,
                       ShapeReading reading = ShapeReading::Converted,
                       const std::function<void(double share)>& tell = {});

}  // namespace resect
