// Facts about a model file. They show whether the model's mesh can be an organ.
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
  // The fields below are computed after points at equal positions were welded (weldSurface() in
  // io/organ_mesh.h).
  bool closed = false;
  int boundaryEdges = 0;
  double volume = 0;  // m^3, >= 0; 0 if the part is open
};

struct ModelInfo {
  std::string path, format;
  std::vector<PartInfo> parts;
  // The fields from here to `bounds` describe the mesh before welding.
  int triangles = 0;
  int vertices = 0;  // number of different positions; a repeated position counts once
  double area = 0;   // m^2
  // Signed volume, m^3 (volume() in geometry/measures.h). For an open surface it depends on where
  // the origin is.
  double volume = 0;
  Aabb bounds;  // m
  // The fields from here to `nonManifoldEdges` describe the mesh after welding (weldSurface()).
  int components = 0;
  bool closed = false, oriented = false, insideOut = false;
  int boundaryEdges = 0, nonManifoldEdges = 0;
  // Name of the unit of length in which the model would have the size of an organ. Empty if the
  // model has this size already, or if it would have this size in no unit.
  std::string unitHint;
  // The fields below come from prepareOrganMesh() (io/organ_mesh.h). If this function refuses the
  // model, organVolume is empty and `refusal` is the function's error message. Otherwise
  // organVolume is the volume of the organ's tissue, m^3. `cavities` is the number of shells of the
  // kind Cavity, and `shellsWithin` is the number of shells of the kind Within (ShellKind in
  // geometry/repair/shells.h). `notes` are the notes that the function has made.
  std::optional<double> organVolume;
  int cavities = 0, shellsWithin = 0;
  std::vector<std::string> notes;
  std::string refusal;
};

// Facts about those parts of the model that options.part names.
ModelInfo modelInfo(const Model& model, const OrganMeshOptions& options = {});

// The fields that `resect info --json` prints. Lengths are in m, areas in m^2, volumes in ml.
nlohmann::ordered_json toJson(const ModelInfo& info);

// The same facts as text for people, with one fact in each line.
std::string toText(const ModelInfo& info);

}  // namespace resect
