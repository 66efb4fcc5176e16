// Files that the Open Asset Import Library (assimp) reads, in single precision, as models.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "io/model.h"

namespace resect {

// The files that the library reads. All are in memory; the library asks for them by name.
struct AssimpInput {
  std::string name;        // of the model file; its extension tells the library the format
  std::string_view bytes;  // content of the model file
  // Content of another file that the model names; data() == nullptr if there is none.
  std::function<std::string_view(const std::string& name)> beside;
};

// Reads the file and adds its nodes to model.parts, in the order of the file, with transforms
// applied. Polygons become triangles; points and lines are left out. Coordinates keep the unit of
// the file. Triangles that a transform mirrors are reversed. model.path: for messages only. Returns
// the library's message if the file is not readable, and nothing if it is. Throws Error if an index
// is out of range or if nodes are nested too deep; std::bad_alloc if there is not enough memory.
std::optional<std::string> readByAssimp(const AssimpInput& input, Model& model);

}  // namespace resect
