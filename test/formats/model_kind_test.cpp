#include "formats/model_kind.h"

#include <doctest/doctest.h>

#include <string>

#include "support/sentence.h"

using namespace resect;

TEST_CASE("the first bytes of a file say more than its name") {
  CHECK(modelKind("a.obj", "ply\nformat ascii 1.0\n") == ModelKind::Ply);
  CHECK(modelKind("a.stl", "PLY\r\n") == ModelKind::Ply);
  CHECK(modelKind("a", "COFF\n8 12 0\n") == ModelKind::Off);
  CHECK(modelKind("a", "SOLID x\n") == ModelKind::Stl);
  CHECK(modelKind("a", "glTF\2") == ModelKind::Glb);
  CHECK(modelKind("a", "\xef\xbb\xbf{ \"asset\": {\"version\": \"2.0\"}}") == ModelKind::Gltf);
  CHECK(modelKind("a", "# vtk DataFile Version 3.0\n") == ModelKind::Vtk);
  CHECK(modelKind("a.obj", "#VRML V2.0 utf8\n") == ModelKind::Inventor);
  CHECK(modelKind("a", "\xef\xbb\xbf\r\n#Inventor V2.1 ascii\n") == ModelKind::Inventor);
}

TEST_CASE("where the first bytes say nothing, the name does, in upper or lower case") {
  CHECK(modelKind("a.b.OBJ", "v 0 0 0\n") == ModelKind::Obj);
  CHECK(modelKind("a.obj.gz", "v 0 0 0\n") == ModelKind::Obj);
  CHECK(modelKind("a.Stl", "\1\2\3") == ModelKind::Stl);
  CHECK(modelKind("a.off", "8 12 0\n") == ModelKind::Off);
  CHECK(modelKind("a.IV", "Separator {}") == ModelKind::Inventor);
  CHECK(modelKind("a.gltf", "hello") == ModelKind::Gltf);
}

TEST_CASE("a binary .stl is one, whatever its header begins with") {
  for (const char* header : {"ply\n", "OFF\n", "solid ", "NRRD0", "{\"asset\""}) {
    std::string bytes(header);
    bytes.resize(80, ' ');
    bytes += std::string("\1\0\0\0", 4) + std::string(50, '\0');
    CHECK(modelKind("a.stl", bytes) == ModelKind::Stl);
  }
  // One whose number of bytes is the one that it says is one under any name.
  const std::string whole =
      std::string(80, ' ') + std::string("\1\0\0\0", 4) + std::string(50, '\0');
  CHECK(modelKind("a.obj", whole) == ModelKind::Stl);
  CHECK(modelKind("a", whole) == ModelKind::Stl);
  CHECK(modelKind("a.obj", whole + "x") == ModelKind::Obj);
}

TEST_CASE("label images are known by their first bytes under any name, else by the name") {
  for (const char* name : {"a", "a.stl", "a.nii.gz"}) {
    CHECK(modelKind(name, std::string(344, '\0') + "n+1") == ModelKind::Nifti);
    CHECK(modelKind(name, std::string(128, '\0') + "DICM ") == ModelKind::Dicom);
    CHECK(modelKind(name, "NRRD0004\n") == ModelKind::Nrrd);
    CHECK(modelKind(name, "ObjectType = Image\n") == ModelKind::MetaImage);
    CHECK(modelKind(name, "NDims=3\n") == ModelKind::MetaImage);
  }
  CHECK(modelKind("a.NII.GZ", "x") == ModelKind::Nifti);
  CHECK(modelKind("a.hdr", "x") == ModelKind::Nifti);
  CHECK(modelKind("a.seg.nrrd", "x") == ModelKind::Nrrd);
  CHECK(modelKind("a.mhd", "x") == ModelKind::MetaImage);
  CHECK(modelKind("a.dcm", "x") == ModelKind::Dicom);
}

TEST_CASE("what is not read is named, with the way to what is") {
  const auto refuses = [](const char* name, const std::string& bytes, const std::string& what) {
    CHECK_MESSAGE(test::refuses([&] { modelKind(name, bytes); }, what), name);
  };
  refuses("a.vtp", "<VTKFile type=\"PolyData\">", "save it as .vtk or .stl");
  refuses("a.VTU", "<?xml version=\"1.0\"?>", "Extract Surface");
  refuses("a.msh", "$MeshFormat\n4.1 0 8\n", "gmsh FILE");
  refuses("a", "$MeshFormat\n4.1 0 8\n", "gmsh FILE");
  refuses("a.amf", "PK\3\4", "export it as .stl");
  refuses("a.vti", "<VTKFile type=\"ImageData\">", "3D Slicer");
  refuses("a.fbx", "Kaydara FBX Binary", "Blender");
  refuses("a.step", "ISO-10303-21;", "FreeCAD");
  refuses("a.xyz", "0 0 0\n", "of no kind that can be read");
  refuses("a", "", "of no kind that can be read");
  for (const char* name : {"a.obj", "a.gltf", "a.wrl", "a.vtk", "a"})
    refuses(name, std::string("\xff\xfe#\0", 4), "UTF-16");
}
