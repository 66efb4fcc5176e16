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

// Whether files of this kind are images, that is, label images or scans.
constexpr bool isImage(ModelKind kind) { return kind >= ModelKind::Nifti; }

// The kind of a model file. bytes: content of the file, decompressed. The kind is recognised by the
// first bytes if they are sufficient. Otherwise it is recognised by the extension of the name,
// which may be in upper or lower case. An extension .gz is ignored. Throws Error if the file has
// none of these kinds. If the file has another common kind (a volume mesh, or a surface in another
// format), the Error says what the file is and how to convert it.
ModelKind modelKind(const std::filesystem::path& path, std::string_view bytes);

}  // namespace resect
