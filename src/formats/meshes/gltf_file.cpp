#include "formats/meshes/gltf_file.h"

#include <optional>

#include "base/error.h"
#include "formats/meshes/assimp_scene.h"
#include "formats/meshes/gltf_requirements.h"
#include "formats/meshes/word_reader.h"

namespace resect {

Model readGltfFile(const std::string& path, std::string_view bytes, const BesideFiles& beside) {
  const bool isBinary = bytes.starts_with("glTF");
  if (!isBinary) bytes = plainText(path, bytes);
  const PlainGltf plain = plainGltf(path, bytes, beside);
  if (!plain.bytes.empty()) bytes = plain.bytes;
  std::optional<std::string> lacking;  // the first file that was asked for and is not there
  AssimpInput input{isBinary ? "model.glb" : "model.gltf", bytes, {}};
  input.beside = [&](const std::string& name) {
    if (name == kPlainPositions) return std::string_view(plain.positions);
    const std::string wanted = withoutPercents(name);
    const auto file = beside.find(wanted);
    if (file != beside.end()) return std::string_view(file->second.data(), file->second.size());
    if (!lacking) lacking = wanted;
    return std::string_view();
  };
  Model model;
  model.path = path;
  model.format = isBinary ? "glTF binary" : "glTF";
  const auto problem = readByAssimp(input, model);
  if (lacking) {
    requireGltfBuffer(path, *lacking);
    throw LacksFile{*lacking};
  }
  if (problem) throw error("{}: not a readable glTF file ({}); export it again", path, *problem);
  return model;
}

}  // namespace resect
