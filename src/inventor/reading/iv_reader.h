// Reads the surfaces of Inventor and VRML files with Coin.
//
// Formats: Inventor V1.0 to V2.1, ascii and binary; VRML 1.0 and 97. For untrusted files call
// readModel() (inventor/reading/model_file.h) instead, which runs this in a child process.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "inventor/reading/scene_model.h"
#include "io/model.h"

namespace resect {

// `bytes`: the file's content, decompressed. `path`: for messages only. Throws Error, with the
// line, for any read error that Coin reports, since Coin then returns a partial scene; only a
// texture that cannot be read is ignored. Not thread-safe. `tell` is called after every 10 000
// numbers with the fraction of the bytes that is read.
Model readInventorFile(const std::string& path, std::string_view bytes,
                       ShapeReading reading = ShapeReading::Converted,
                       const std::function<void(double share)>& tell = {});

}  // namespace resect
