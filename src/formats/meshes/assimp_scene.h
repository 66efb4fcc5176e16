// Reads models through the Open Asset Import Library (assimp), in single precision.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "io/model.h"

namespace resect {

// The files that the library may read. Their contents are in memory, and the library asks for a
// file by its name.
struct AssimpInput {
  std::string name;        // name of the model file; its extension tells the format
  std::string_view bytes;  // content of the model file
  // Returns the content of another file that the model refers to by `name`. If there is no such
  // file, data() of the result is null.
  std::function<std::string_view(const std::string& name)> beside;
};

// Reads the file and adds each of its nodes to model.parts, in the order of the file. The
// transforms of the nodes are applied. If a transform mirrors triangles, the order of their corners
// is reversed. Polygons become triangles. Points and lines are left out. Coordinates keep the unit
// of the file. model.path: for messages only. If the library cannot read the file, returns the
// library's message; otherwise returns nothing. Throws Error if an index is out of range, or if
// nodes are nested too deep. Throws std::bad_alloc if there is not enough memory.
std::optional<std::string> readByAssimp(const AssimpInput& input, Model& model);

}  // namespace resect
