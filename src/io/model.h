// The content of a model file: named meshes as in the file, in metres (a file without units counts
// as metres).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "geometry/triangle_mesh.h"

namespace resect {

// One named mesh of the file: its transforms are applied, no points are welded, no triangle is
// dropped.
struct ModelPart {
  std::string name;  // as the file calls it; may be empty
  TriangleMesh mesh;
};

struct Model {
  std::string path;
  std::string format;            // "Inventor V2.1 binary", "STL", ...
  std::vector<ModelPart> parts;  // in the order of the file; no two have one name
};

// All parts as one mesh.
TriangleMesh merged(const Model& model);

// Appends a mesh to the part of that name, which is created if there is none.
void addToPart(Model& model, const std::string& name, TriangleMesh mesh);

// The part of that name; an Error lists the names if there is none.
const ModelPart& partNamed(const Model& model, const std::string& name);

// The names of the first `most` parts, as "a, b, c and 23 more"; a name longer than 60 characters
// is cut.
std::string partList(const Model& model, std::size_t most = 40);

// Throws Error for what no reader may return: no triangles at all, an index out of range, a
// coordinate that is not finite or beyond 1e9 m.
void checkModel(const Model& model);

// The model as bytes and back, for sending through a pipe. bytesToModel() throws Error if the bytes
// are cut off or too many, or if checkModel() refuses the model.
std::string modelToBytes(const Model& model);
Model bytesToModel(std::string_view bytes, const std::string& path);

}  // namespace resect
