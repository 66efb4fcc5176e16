// The content of a model file: its named meshes, in metres. Numbers of a file without units are
// taken as metres.
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
  std::string name;  // as in the file; may be empty
  TriangleMesh mesh;
  // For pictures: one normal per point. It is a unit vector, or zero if the file has no normal for
  // this point. The list is empty if the file has no normals for the part. Only the reader of
  // Inventor files fills it.
  std::vector<Vec3f> normals{};
  std::optional<Finish> finish{};  // of the first shape of the part
};

// Poses of the tools and of the camera in a saved scene (inventor/scene/scene_file.h), in world
// coordinates.
struct ScenePlaces {
  std::vector<Pose> tools;  // in the order of the saved scene; at most kMostSceneTools
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

// Appends a mesh to the part with that name. If there is no such part yet, adds it. A mesh without
// triangles is ignored.
void addToPart(Model& model, const std::string& name, TriangleMesh mesh);
// The same for a mesh with normals and a finish. The part gets the finish of the first mesh that
// was appended to it.
void addToPart(Model& model, ModelPart piece);

// A list of names of parts is given to the program as one text with one name per line. partNames()
// gives the names in such a text, partLines() the text for such names.
std::vector<std::string> partNames(const std::string& lines);
std::string partLines(const std::vector<std::string>& names);
// A line that begins with kWithout names a part that is left out, whatever the other lines name.
inline constexpr std::string_view kWithout = "without ";
// Adds lines to `lines` that leave out the parts named by `out`, if they are not there yet.
void leaveOut(std::string& lines, const std::string& out);

// The model with only the parts that `lines` names (partNames()), in the order of the file. Returns
// all parts if `lines` is empty, or if the model has only one part and `lines` is its name; if all
// lines leave parts out, returns the other parts. If there is no part with one of the names, or if
// no part is left, throws an Error that lists the names of the parts.
Model chosenParts(const Model& model, const std::string& lines);

// The part with that name. If there is none, throws an Error that lists the names of the parts.
const ModelPart& partNamed(const Model& model, const std::string& name);

inline constexpr std::size_t kLongestName = 60;  // characters of a part's name in a message

// The names of the first `most` parts, such as "a, b, c and 23 more". Names longer than
// kLongestName are shortened to their beginning and end.
std::string partList(const Model& model, std::size_t most = 40);

// Throws Error if the model is not valid as the result of a reader: if it has no triangles, if an
// index is out of range, if a coordinate is not finite or its absolute value is above 1e9 m, if a
// part has normals but not one per point, if a normal is neither a unit vector nor zero, if a
// number of a finish or of `places` is out of range, or if `places` has more than kMostSceneTools
// tools.
void checkModel(const Model& model);

// For sending a model through a pipe: modelToBytes() gives its bytes, bytesToModel() makes the
// model from them. bytesToModel() throws Error if bytes are missing or left over, or if
// checkModel() refuses the model.
std::string modelToBytes(const Model& model);
Model bytesToModel(std::string_view bytes, const std::string& path);

}  // namespace resect
