// Finds out the kind of a model file.
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

// The kind of a file with this content (decompressed). It is recognised by the first bytes if these
// are sufficient, otherwise by the extension of the name (upper or lower case, without .gz). Throws
// Error for all other files. For common kinds among those (volume meshes, other surfaces) the Error
// says what the file is and how to convert it.
ModelKind modelKind(const std::filesystem::path& path, std::string_view bytes);

}  // namespace resect
