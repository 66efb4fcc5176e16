// The content of a model file: its named meshes, in metres. If a file names no unit, its numbers
// are taken as metres.
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
  // Inventor files fills this list.
  std::vector<Vec3f> normals{};
  std::optional<Finish> finish{};  // finish of the part's first shape
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

// Appends a mesh to the part with that name. If there is no part with that name yet, adds the part.
// A mesh without triangles is ignored.
void addToPart(Model& model, const std::string& name, TriangleMesh mesh);
// Does the same with a mesh that has normals and a finish. The part gets the finish of the first
// mesh that was appended to it.
void addToPart(Model& model, ModelPart piece);

// The program takes a list of names of parts as one text, with one name per line. partNames()
// splits such a text into the names. partLines() joins names to such a text.
std::vector<std::string> partNames(const std::string& lines);
std::string partLines(const std::vector<std::string>& names);
// A line that begins with kWithout names a part that is to be left out. This part is left out even
// if another line names it.
inline constexpr std::string_view kWithout = "without ";
// For each part that `out` names, adds a line to `lines` that leaves out this part. A line that
// `lines` already has is not added again.
void leaveOut(std::string& lines, const std::string& out);

// The model with only the parts that `lines` names (partNames()), in the order of the file.
// - If `lines` is empty, returns all parts.
// - If the model has only one part and `lines` is this part's name, returns this part. (A
//   ModelReader may have joined several parts to one, whose name has several lines.)
// - If all lines leave parts out (kWithout), returns the other parts.
// - If the model has no part with one of the names, or if no part is left, throws an Error that
//   lists the names of the parts.
Model chosenParts(const Model& model, const std::string& lines);

// The part with that name. If there is no such part, throws an Error that lists the names of the
// parts.
const ModelPart& partNamed(const Model& model, const std::string& name);

inline constexpr std::size_t kLongestName = 60;  // characters of a part's name in a message

// The names of the first `most` parts and the number of the others, such as "a, b, c and 23 more".
// Names longer than kLongestName are shortened to their beginning and end.
std::string partList(const Model& model, std::size_t most = 40);

// Checks the result of a reader. Throws Error in these cases:
// - The model has no triangles.
// - An index is out of range.
// - A coordinate is not finite, or its absolute value is above 1e9 m.
// - A part has normals, but not one per point.
// - A normal is neither a unit vector nor zero.
// - A number of a finish or of `places` is out of range.
// - `places` has more than kMostSceneTools tools.
void checkModel(const Model& model);

// These functions send a model through a pipe. modelToBytes() converts the model to bytes.
// bytesToModel() makes a model from such bytes. It throws Error if bytes are missing or left over,
// or if checkModel() refuses the model.
std::string modelToBytes(const Model& model);
Model bytesToModel(std::string_view bytes, const std::string& path);

}  // namespace resect
