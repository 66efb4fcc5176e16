// Which surfaces does an Inventor or VRML file hold?
//
// Read by Coin: Inventor V1.0 to V2.1, ascii and binary, VRML 1.0 and 97. Untrusted files: call it
// through readModel (inventor/reading/model_file.h), which does it in a child process.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "inventor/reading/scene_model.h"
#include "io/model.h"

namespace resect {

// The bytes of the file, no longer compressed; `path` is only for messages. Any read error makes
// the whole file an Error with its line, since Coin returns half a scene then; only a texture that
// cannot be read is passed over. One thread. `tell` gets the share read at every 10 000th number.
Model readInventorFile(const std::string& path, std::string_view bytes,
                       ShapeReading reading = ShapeReading::Converted,
                       const std::function<void(double share)>& tell = {});

}  // namespace resect
