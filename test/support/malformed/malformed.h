// Damaged, malicious and absurd files that every reader must survive.
//
// Made here, always the same: about 120 models, and any number of discretisation and scenario files
// out of a valid one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace resect::test {

struct BadFile {
  std::string name;  // tells the trouble and, by its extension, the claimed format
  std::string bytes;
  bool mayBeFine = false;  // the damage may leave something that is still valid
};

std::vector<BadFile> malformedInventorFiles();  // .iv .wrl
std::vector<BadFile> malformedMeshFiles();      // .obj .stl .ply .off .glb .gltf .vtk
std::vector<BadFile> malformedGzipFiles();      // .iv.gz and the like

// 40 files each: edits of single lines and numbers of a valid text, cuts and noise; names end as
// `extension` (".dis", ".toml").
std::vector<BadFile> malformedDiscretizations(const std::string& valid);
std::vector<BadFile> malformedScenarios(const std::string& valid);

// `count` copies of `valid`, each damaged in a few random bytes, lines or its length; always the
// same for the same seed.
std::vector<BadFile> mutated(std::string_view valid, const std::string& extension, int count,
                             unsigned seed);

// The first line of an Inventor file in text form.
inline const std::string kInventorHead = "#Inventor V2.1 ascii\n";

// Small valid files to damage: a unit cube as Inventor binary, a triangle as glTF binary.
std::string binaryInventorCube();
std::string binaryGltf(const std::string& json, const std::string& data);

}  // namespace resect::test
