// Reads the surfaces of Inventor and VRML files with Coin.
//
// Formats: Inventor V1.0 to V2.1, ascii and binary, VRML 1.0 and 97. Untrusted files: call it
// through readModel (inventor/reading/model_file.h), which does it in a child process.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "inventor/reading/scene_model.h"
#include "io/model.h"

namespace resect {

// `bytes`: the file's content, decompressed; `path`: for messages only. Any read error is an Error
// with its line, since Coin then returns a partial scene; only a texture that cannot be read is
// ignored. Not thread-safe. `tell` gets the fraction read at every 10 000th number.
Model readInventorFile(const std::string& path, std::string_view bytes,
                       ShapeReading reading = ShapeReading::Converted,
                       const std::function<void(double share)>& tell = {});

}  // namespace resect
