// The content of a model file: its named meshes, in metres. A file without units is taken to be in
// metres.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/pose.h"
#include "geometry/triangle_mesh.h"
#include "tools/finish.h"

namespace resect {

// One named mesh of the file, with its transforms applied. No points are welded and no triangle is
// dropped.
struct ModelPart {
  std::string name;  // as the file calls it; may be empty
  TriangleMesh mesh;
  // For pictures: one normal per point, a unit vector, or zero if the file gives this point none.
  // The list is empty if the file gives no point of the part a normal. Only the reader of Inventor
  // files fills it.
  std::vector<Vec3f> normals{};
  std::optional<Finish> finish{};  // of the first shape of the part
};

// Poses of the tools and of the camera in a saved scene (inventor/scene/scene_file.h), in world
// coordinates.
struct ScenePlaces {
  std::vector<Pose> tools;  // in the order of the room that was saved; at most kMostSceneTools
  Pose camera;
  double heightAngle = 0;    // the camera's angle of view from bottom to top, rad, 0 to pi
  double focalDistance = 0;  // m, > 0
};

constexpr std::size_t kMostSceneTools = 1000;

struct Model {
  std::string path;
  std::string format;                   // "Inventor V2.1 binary", "STL", ...
  std::vector<ModelPart> parts;         // in the order of the file; no two have the same name
  std::optional<ScenePlaces> places{};  // if the file is a saved scene
};

// All parts as one mesh.
TriangleMesh merged(const Model& model);

// Appends a mesh to the part of that name, or to a new part of that name if there is none yet. A
// mesh without triangles is ignored.
void addToPart(Model& model, const std::string& name, TriangleMesh mesh);
// The same for a piece that may have normals and a finish. The part gets the finish of the first
// piece.
void addToPart(Model& model, ModelPart piece);

// Names of parts are given to the program as one text, with a line for each.
std::vector<std::string> partNames(const std::string& lines);
std::string partLines(const std::vector<std::string>& names);

// The model with only the parts that `lines` names (partNames()), in the order of the file. All
// parts if `lines` is empty, or if the only part has it as its name. If there is no part of such a
// name, throws an Error that lists the names of the parts.
Model chosenParts(const Model& model, const std::string& lines);

// The part of that name. If there is none, throws an Error that lists the names of the parts.
const ModelPart& partNamed(const Model& model, const std::string& name);

inline constexpr std::size_t kLongestName = 60;  // characters of a part's name in a message

// The names of the first `most` parts, as "a, b, c and 23 more". Of a name longer than kLongestName
// only the beginning and the end are shown.
std::string partList(const Model& model, std::size_t most = 40);

// Throws Error if no reader may return this model. So it is if the model has no triangles, if an
// index is out of range, if a coordinate is not finite or its absolute value is above 1e9 m, if a
// part has another number of normals than of points, if a normal is neither unit nor zero, if a
// number of a finish or of `places` is out of range, or if `places` has more than kMostSceneTools
// tools.
void checkModel(const Model& model);

// For sending a model through a pipe: modelToBytes() gives its bytes, bytesToModel() makes the
// model from them. bytesToModel() throws Error if bytes are missing or left over, or if
// checkModel() refuses the model.
std::string modelToBytes(const Model& model);
Model bytesToModel(std::string_view bytes, const std::string& path);

}  // namespace resect
