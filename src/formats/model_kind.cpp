#include "formats/model_kind.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "base/error.h"
#include "formats/images/dicom_file.h"
#include "formats/images/meta_image_file.h"
#include "formats/images/nifti_file.h"
#include "formats/images/nrrd_file.h"
#include "formats/meshes/off_file.h"
#include "formats/meshes/ply_file.h"
#include "formats/meshes/stl_file.h"
#include "formats/meshes/three_mf_file.h"
#include "formats/meshes/vtk_file.h"
#include "formats/meshes/word_reader.h"

namespace resect {
namespace {

namespace fs = std::filesystem;

struct Ending {
  std::string_view ending;  // of the file's name
  ModelKind kind;
};
constexpr std::array<Ending, 17> kEndings{{{".iv", ModelKind::Inventor},
                                           {".wrl", ModelKind::Inventor},
                                           {".vtk", ModelKind::Vtk},
                                           {".obj", ModelKind::Obj},
                                           {".stl", ModelKind::Stl},
                                           {".ply", ModelKind::Ply},
                                           {".off", ModelKind::Off},
                                           {".glb", ModelKind::Glb},
                                           {".gltf", ModelKind::Gltf},
                                           {".3mf", ModelKind::ThreeMf},
                                           {".nii", ModelKind::Nifti},
                                           {".hdr", ModelKind::Nifti},
                                           {".nrrd", ModelKind::Nrrd},
                                           {".nhdr", ModelKind::Nrrd},
                                           {".mha", ModelKind::MetaImage},
                                           {".mhd", ModelKind::MetaImage},
                                           {".dcm", ModelKind::Dicom}}};

constexpr const char* kBySlicer = "open it in 3D Slicer or ParaView and save it as .vtk or .stl";
constexpr const char* kByGmsh =
    "write its surface as .stl, with gmsh FILE -o surface.stl -format stl";
constexpr const char* kByBlender = "open it in Blender and export it as .glb or .stl";
constexpr const char* kByPrinting = "open it in a program for 3D printing and export it as .stl";

// What is not read, and the way to what is.
struct OtherKind {
  std::string_view ending;
  std::string_view start;  // its first bytes, or nothing
  std::size_t at;          // where these are
  const char* what;
  const char* advice;
};
constexpr std::array<OtherKind, 14> kOthers{{
    {".vtp", "", 0, "a surface in VTK's XML form", kBySlicer},
    {".vtu", "", 0, "a volume mesh in VTK's XML form",
     "extract its surface (ParaView: Extract Surface) and save it as .vtk or .stl"},
    {".vti", "", 0, "an image in VTK's XML form",
     "open it in 3D Slicer and save its labels as .nrrd"},
    {".msh", "$MeshFormat", 0, "a volume mesh of Gmsh", kByGmsh},
    {".amf", "", 0, "a model for 3D printing", kByPrinting},
    {".fbx", "Kaydara FBX", 0, "a scene (FBX)", kByBlender},
    {".blend", "BLENDER", 0, "a scene of Blender", kByBlender},
    {".dae", "", 0, "a scene (COLLADA)", kByBlender},
    {".x3d", "", 0, "a scene (X3D)", kByBlender},
    {".usdz", "", 0, "a scene (USD)", kByBlender},
    {".usdc", "PXR-USDC", 0, "a scene (USD)", kByBlender},
    {".step", "ISO-10303-21", 0, "a solid of a CAD program (STEP)",
     "open it in FreeCAD and export it as .stl"},
    {".stp", "ISO-10303-21", 0, "a solid of a CAD program (STEP)",
     "open it in FreeCAD and export it as .stl"},
    {".mesh", "MeshVersionFormatted", 0, "a volume mesh of Medit", kByGmsh},
}};

std::string endingOf(const fs::path& path) {
  const std::string ending = lowerCase(path.extension().string());
  return ending == ".gz" ? lowerCase(path.stem().extension().string()) : ending;
}

// glTF as text is a JSON object that says which version of an asset it is.
bool startsAsGltf(std::string_view bytes) {
  const std::size_t begin = bytes.find_first_not_of("\xef\xbb\xbf \t\r\n");
  return begin != bytes.npos && bytes[begin] == '{' && bytes.find("\"asset\"") != bytes.npos;
}

std::optional<ModelKind> kindByContent(std::string_view bytes) {
  const std::size_t begin = std::min(bytes.find_first_not_of("\xef\xbb\xbf \t\r\n"), bytes.size());
  const std::string_view text = bytes.substr(begin);
  if (text.starts_with("#Inventor V") || text.starts_with("#VRML V")) return ModelKind::Inventor;
  if (isVtkFile(bytes)) return ModelKind::Vtk;
  if (startsAsNifti(bytes)) return ModelKind::Nifti;
  if (startsAsNrrd(bytes)) return ModelKind::Nrrd;
  if (startsAsMetaImage(text)) return ModelKind::MetaImage;
  if (startsAsDicom(bytes)) return ModelKind::Dicom;
  if (bytes.starts_with("glTF")) return ModelKind::Glb;
  if (isThreeMf(bytes)) return ModelKind::ThreeMf;
  if (startsAsPly(bytes)) return ModelKind::Ply;
  if (startsAsOff(bytes)) return ModelKind::Off;
  if (startsAsTextStl(bytes)) return ModelKind::Stl;
  if (startsAsGltf(bytes)) return ModelKind::Gltf;
  if (isExactBinaryStl(bytes)) return ModelKind::Stl;
  return std::nullopt;
}

}  // namespace

ModelKind modelKind(const fs::path& path, std::string_view bytes) {
  const std::string ending = endingOf(path);
  // The header of a binary .stl may begin with anything.
  if (ending == ".stl" && isExactBinaryStl(bytes)) return ModelKind::Stl;
  if (bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff"))
    plainText(path.string(), bytes);  // which refuses it
  if (const std::optional<ModelKind> kind = kindByContent(bytes)) return *kind;
  const auto ours = std::ranges::find(kEndings, ending, &Ending::ending);
  const auto isThis = [&](const OtherKind& other) {
    const bool starts = !other.start.empty() && bytes.size() > other.at &&
                        bytes.substr(other.at).starts_with(other.start);
    return starts || (ours == kEndings.end() && other.ending == ending);
  };
  const auto other = std::ranges::find_if(kOthers, isThis);
  if (other != kOthers.end())
    throw error("{}: is {}, which is not read; {}", path.string(), other->what, other->advice);
  if (ours != kEndings.end()) return ours->kind;
  throw error(
      "{}: is of no kind that can be read; use .iv, .wrl, .obj, .stl, .ply, .off, .glb, .gltf, "
      ".3mf, .vtk, or a label image .nii, .nrrd, .mha or DICOM",
      path.string());
}

}  // namespace resect
