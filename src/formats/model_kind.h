// Finds of which kind a model file is.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace resect {

enum class ModelKind : std::uint8_t {
  Inventor,
  Vtk,
  Obj,
  Stl,
  Ply,
  Off,
  Glb,
  Gltf,
  ThreeMf,
  Nifti,
  Nrrd,
  MetaImage,
  Dicom
};

// Whether files of the kind are images: label images or scans.
constexpr bool isImage(ModelKind kind) { return kind >= ModelKind::Nifti; }

// The kind of a file with this content (decompressed), by its first bytes where these are
// sufficient, otherwise by the extension of its name, in upper or lower case, before a .gz. Throws
// Error for all other files. For those that people often have (volume meshes, other surfaces) the
// Error says what they are and how to make a model of them.
ModelKind modelKind(const std::filesystem::path& path, std::string_view bytes);

}  // namespace resect
