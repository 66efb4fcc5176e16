// The content of a model file: named meshes as in the file, in metres.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "geometry/triangle_mesh.h"

namespace resect {

// One named piece of the file: transforms applied, nothing welded, no triangle dropped.
struct ModelPart {
  std::string name;  // as the file calls it; may be empty
  TriangleMesh mesh;
};

struct Model {
  std::string path;
  std::string format;            // "Inventor V2.1 binary", "STL", ...
  std::vector<ModelPart> parts;  // in the order of the file; names differ
};

// All parts as one mesh.
TriangleMesh merged(const Model& model);

// Appends a mesh to the part of that name, which is created if there is none.
void addToPart(Model& model, const std::string& name, TriangleMesh mesh);

// The part of that name; an Error lists the names if there is none.
const ModelPart& partNamed(const Model& model, const std::string& name);

// "a, b, c and 23 more"; names longer than a line are cut.
std::string partList(const Model& model, std::size_t most = 40);

// Throws Error for what no reader may return: no triangles at all, an index out of range, a
// coordinate that is not finite or beyond 1e9 m.
void checkModel(const Model& model);

// The model as bytes and back, for sending through a pipe. bytesToModel checks everything: any
// damage is an Error.
std::string modelToBytes(const Model& model);
Model bytesToModel(std::string_view bytes, const std::string& path);

}  // namespace resect
