// Instruments that users bring, of any format: they are shown, their jaws close, and none ends the
// program.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry/primitives.h"
#include "geometry/rotation.h"
#include "inventor/picture/offscreen_view.h"
#include "inventor/reading/model_file.h"
#include "inventor/scene/operation_view.h"
#include "io/mesh_file.h"
#include "io/operation_setup.h"
#include "support/malformed/malformed.h"
#include "support/sentence.h"
#include "support/temporary_folder.h"

using namespace resect;

namespace {

constexpr double kOpening = 0.6;
const Vec3 kPivot(0, 0, 0.08);
const Vec3 kTip(0, 0.3, 0);

void writeDescription(const test::TemporaryFolder& folder, const std::string& model) {
  folder.write("own.toml", "name = \"Own\"\nkind = \"baton\"\nmodel = \"" + model +
                               "\"\njaw_opening = 0.6\njaw_pivot = [0, 0, 0.08]\n");
}

// A picture of the instrument own.toml of the folder in the air; without one, of the air.
RgbImage picture(const test::TemporaryFolder* folder, double squeeze = 0) {
  Scenario scenario;
  scenario.organs[0].source.spacing = 0.02;
  scenario.table = scenario.toolBox = false;
  scenario.view = "assistant";
  scenario.closeUp = Aabb{kTip - Vec3(0.04, 0.04, 0.01), kTip + Vec3(0.04, 0.04, 0.16)};
  if (folder) scenario.tools.push_back({*folder / "own.toml", {}, {}, {}});
  Simulation simulation = makeSimulation(scenario, &readModel);
  OffscreenView screen(240, 160);
  OperationView view(scenario, simulation, 1.5);
  FrameInput input;
  if (folder) input.tools.push_back({{kTip, Eigen::Quaterniond::Identity()}, true, squeeze});
  simulation.step(input);
  view.follow(simulation);
  return view.draw(screen);
}

// Share of pixels whose colours differ by more than eyes overlook.
double changedShare(const RgbImage& a, const RgbImage& b) {
  int pixels = 0;
  for (std::size_t i = 0; i < a.pixels.size(); i += 3) {
    int most = 0;
    for (std::size_t c = i; c < i + 3; ++c)
      most = std::max(most, std::abs(int(a.pixels[c]) - int(b.pixels[c])));
    pixels += most > 8;
  }
  return pixels / (a.pixels.size() / 3.0);
}

// A rod of the size of an instrument, and a line of Inventor around its shape.
const TriangleMesh kRod = boxMesh({{-0.01, -0.01, 0}, {0.01, 0.01, 0.15}});

std::string inventorRod(const std::string& before, const std::string& inShape) {
  std::string points, faces;
  for (const Vec3& p : kRod.points) points += fmt::format("{} {} {}, ", p.x(), p.y(), p.z());
  for (const Triangle& t : kRod.triangles) faces += fmt::format("{},{},{},-1, ", t[0], t[1], t[2]);
  return "Separator { " + before + " Coordinate3 { point [ " + points +
         " ] } IndexedFaceSet { coordIndex [ " + faces + " ] " + inShape + " } }\n";
}

std::string times(int count, const std::string& number) {
  std::string list;
  for (int i = 0; i < count; ++i) list += number + ", ";
  return "[ " + list + " ]";
}

TriangleMesh turned(TriangleMesh mesh, double angle) {
  const Eigen::Quaterniond turn = rotationAbout(Vec3::UnitX(), angle);
  for (Vec3& p : mesh.points) p = kPivot + turn * (p - kPivot);
  return mesh;
}

// An .obj file of a handle and two jaws that are turned by `angle` and -angle.
std::string objOfJaws(double angle, const char* upper, const char* lower) {
  std::string text;
  int points = 0;
  const auto add = [&](const char* name, const TriangleMesh& mesh) {
    text += fmt::format("o {}\n", name);
    for (const Vec3& p : mesh.points) text += fmt::format("v {} {} {}\n", p.x(), p.y(), p.z());
    for (const Triangle& t : mesh.triangles)
      text += fmt::format("f {} {} {}\n", points + t[0] + 1, points + t[1] + 1, points + t[2] + 1);
    points += int(mesh.points.size());
  };
  add("Handle", boxMesh({{-0.005, -0.005, 0.082}, {0.005, 0.005, 0.15}}));
  add(upper, turned(boxMesh({{-0.004, 0.001, 0}, {0.004, 0.008, 0.08}}), angle));
  add(lower, turned(boxMesh({{-0.004, -0.008, 0}, {0.004, -0.001, 0.08}}), -angle));
  return text;
}

// The rod as glTF: positions and indices of one node.
std::string gltfOfRod() {
  std::string data;
  const auto put = [&](const auto& value) {
    data.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  for (const Vec3& p : kRod.points)
    for (int k = 0; k < 3; ++k) put(float(p[k]));
  const std::size_t points = kRod.points.size(), indices = 3 * kRod.triangles.size();
  for (const Triangle& t : kRod.triangles)
    for (const std::int32_t i : t) put(std::uint32_t(i));
  return test::binaryGltf(
      fmt::format(R"({{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],)"
                  R"("nodes":[{{"mesh":0}}],)"
                  R"("meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},"indices":1}}]}}],)"
                  R"("accessors":[{{"bufferView":0,"componentType":5126,"count":{},"type":"VEC3",)"
                  R"("min":[-0.01,-0.01,0],"max":[0.01,0.01,0.15]}},)"
                  R"({{"bufferView":1,"componentType":5125,"count":{},"type":"SCALAR"}}],)"
                  R"("bufferViews":[{{"buffer":0,"byteLength":{}}},)"
                  R"({{"buffer":0,"byteOffset":{},"byteLength":{}}}],)"
                  R"("buffers":[{{"byteLength":{}}}]}})",
                  points, indices, 12 * points, 12 * points, 4 * indices, data.size()),
      data);
}

}  // namespace

TEST_CASE("an instrument of any format is shown, and looks the same in all of them") {
  const RgbImage air = picture(nullptr);
  const test::TemporaryFolder folder;
  for (const char* name : {"own.obj", "own.stl", "own.ply", "own.vtk", "own.iv"})
    writeMeshFile(folder / name, kRod);
  folder.write("own.glb", gltfOfRod());
  std::vector<RgbImage> pictures;
  for (const std::string name : {"own.iv", "own.obj", "own.stl", "own.ply", "own.vtk", "own.glb"}) {
    CAPTURE(name);
    writeDescription(folder, name);
    pictures.push_back(picture(&folder));
    CHECK(changedShare(air, pictures.back()) > 0.03);
    CHECK(changedShare(pictures.front(), pictures.back()) < 1e-3);
  }
}

TEST_CASE("jaws of a foreign .obj file close in the picture") {
  const test::TemporaryFolder folder;
  writeDescription(folder, "own.obj");
  folder.write("own.obj", objOfJaws(0, "First", "Second"));
  const RgbImage shut = picture(&folder);
  folder.write("own.obj", objOfJaws(0.5 * kOpening, "JawUpper", "JawLower.001"));
  const RgbImage closed = picture(&folder, 1), open = picture(&folder, 0);
  CHECK(changedShare(closed, shut) < 1e-3);
  CHECK(changedShare(open, shut) > 0.01);
  folder.write("own.obj", objOfJaws(0.5 * kOpening, "First", "Second"));
  CHECK(changedShare(open, picture(&folder)) < 1e-3);
}

TEST_CASE("an instrument that would end Coin gives a picture or a sentence") {
  const std::string wild = times(60, "90000000"), below = times(60, "-90000000");
  const std::string each = " value PER_VERTEX_INDEXED }\n";
  const std::pair<std::string, std::string> files[] = {
      {"normalIndex",
       inventorRod("Normal { vector [ 0 0 1 ] } NormalBinding {" + each, "normalIndex " + wild)},
      {"negative normalIndex",
       inventorRod("Normal { vector [ 0 0 1 ] } NormalBinding {" + each, "normalIndex " + below)},
      {"few normals", inventorRod("Normal { vector [ 0 0 1 ] } NormalBinding {" + each, "")},
      {"normals of no length",
       inventorRod("Normal { vector [ 1e30 0 0, 0 0 0 ] } NormalBinding {" + each, "")},
      {"materialIndex",
       inventorRod("Material { diffuseColor [ 1 0 0, 0 1 0 ] } MaterialBinding {" + each,
                   "materialIndex " + wild)},
      {"materials out of range",
       inventorRod("Material { diffuseColor 1e30 -7 0.5 specularColor 9 9 9 shininess 1e9 }", "")},
      {"no material", inventorRod("Material { diffuseColor [ ] specularColor [ ] }", "")},
      {"textureCoordIndex",
       inventorRod("Texture2 { image 1 1 3 0xff0000 } TextureCoordinate2 { point [ 0 0 ] } "
                   "TextureCoordinateBinding {" +
                       each,
                   "textureCoordIndex " + wild)},
      {"numPoints", inventorRod("", "") + "PointSet { numPoints 90000000 }\n"},
      {"numVertices", inventorRod("", "") + "LineSet { numVertices [ 90000000 ] }\n"},
      {"jaw far away", inventorRod("", "") +
                           "DEF JawUpper Separator { Transform { translation 1e30 "
                           "0 0 } " +
                           inventorRod("", "") + "}\n"},
      {"large jaw", inventorRod("", "") +
                        "DEF JawUpper Separator { Transform { scaleFactor 1e10 "
                        "1e10 1e10 } " +
                        inventorRod("", "") + "}\n"},
      {"jaw of no size", inventorRod("", "") +
                             "DEF JawLower Separator { Transform { scaleFactor 0 "
                             "0 0 rotation 0 0 0 1e38 } " +
                             inventorRod("", "") + "}\n"},
  };
  const test::TemporaryFolder folder;
  writeDescription(folder, "own.iv");
  int shown = 0;
  for (const auto& [name, body] : files) {
    CAPTURE(name);
    folder.write("own.iv", "#Inventor V2.1 ascii\nSeparator {\n" + body + "}\n");
    const std::string sentence = test::sentenceOf([&] { picture(&folder, 0.5); });
    if (sentence.empty()) {
      ++shown;
      continue;
    }
    CHECK(test::isOneSentence(sentence));
    CHECK(test::tells(sentence, "own.iv"));
  }
  CHECK(shown >= 9);
}

TEST_CASE("a jaw that is neither the upper nor the lower one is told") {
  const test::TemporaryFolder folder;
  writeDescription(folder, "own.obj");
  folder.write("own.obj", objOfJaws(0.3, "JawLeft", "JawRight"));
  CHECK(test::refuses([&] { picture(&folder); }, "JawLeft"));
}

TEST_CASE("the room's models are those of Resect and no others") {
  CHECK(test::refuses([] { readRoomModel("../tools/table"); }, "no model"));
  CHECK(test::refuses([] { readRoomModel("scissors"); }, "no model"));
}
