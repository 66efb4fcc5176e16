// Reads the surfaces of Inventor and VRML files with Coin.
//
// Formats: Inventor V1.0 to V2.1, ascii and binary; VRML 1.0 and 97. For untrusted files call
// readModel() (inventor/reading/model_file.h) instead, which does the reading in a child process.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "inventor/reading/scene_model.h"
#include "io/model.h"

namespace resect {

// `bytes`: the file's content, decompressed. `path`: for messages only. `tell`: called after every
// 10 000 numbers with the fraction of the bytes that has been read. After a read error Coin returns
// a partial scene; so each read error that Coin reports throws an Error with the line. Only a
// texture that cannot be read is ignored. Not thread-safe.
Model readInventorFile(const std::string& path, std::string_view bytes,
                       ShapeReading reading = ShapeReading::Converted,
                       const std::function<void(double share)>& tell = {});

}  // namespace resect
