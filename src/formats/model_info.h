// Facts about a model file, which show whether its mesh can be an organ.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "geometry/aabb.h"
#include "io/model.h"
#include "io/organ_mesh.h"

namespace resect {

struct PartInfo {
  std::string name;
  int triangles = 0;
  // After welding (weldSurface):
  bool closed = false;
  int boundaryEdges = 0;
  double volume = 0;  // m^3, >= 0; 0 for an open part
};

struct ModelInfo {
  std::string path, format;
  std::vector<PartInfo> parts;
  // As read:
  int triangles = 0;
  int vertices = 0;  // distinct positions, however often the file repeats them
  double area = 0;   // m^2
  // m^3: sum of the signed volumes of the tetrahedra that the triangles form with the origin. For
  // an open surface the sum depends on where the origin is.
  double volume = 0;
  Aabb bounds;  // m
  // After welding (weldSurface):
  int components = 0;
  bool closed = false, oriented = false, insideOut = false;
  int boundaryEdges = 0, nonManifoldEdges = 0;
  std::string unitHint;  // unit in which the model would have an organ's size; empty: metres
  // Result of prepareOrganMesh() for the model: the volume of the organ's tissue, m^3, how many of
  // its shells bound a cavity and how many lie within tissue (ShellKind), and the notes about it;
  // or the error message with which it refuses the model.
  std::optional<double> organVolume;
  int cavities = 0, shellsWithin = 0;
  std::vector<std::string> notes;
  std::string refusal;
};

// Facts about the parts of the model that options.part names.
ModelInfo modelInfo(const Model& model, const OrganMeshOptions& options = {});

// The fields of `resect info --json`, lengths in m, area in m^2, volume in ml.
nlohmann::ordered_json toJson(const ModelInfo& info);

// The same facts as text for a person, one in each line.
std::string toText(const ModelInfo& info);

}  // namespace resect
