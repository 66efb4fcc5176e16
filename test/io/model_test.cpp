// What a reader's child process sends of pictures and saved scenes is checked number by number.
#include "io/model.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "base/error.h"
#include "geometry/primitives.h"
#include "geometry/rotation.h"
#include "support/sentence.h"

using namespace resect;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Model scene() {
  Model model{"scene.iv", "Inventor V2.1 ascii", {{"Organ", boxMesh({{0, 0, 0}, {1, 1, 1}})}}};
  ModelPart& part = model.parts[0];
  part.normals.assign(part.mesh.points.size(), Vec3f::UnitZ());
  part.normals[2].setZero();
  part.finish = Finish{{0.1f, 0.2f, 0.3f}, {0.4f, 0.5f, 0.6f}, 0.7f};
  model.places.emplace();
  model.places->tools = {{{0.1, 0.2, 0.3}, rotationAbout(Vec3::UnitY(), 0.4)}, Pose()};
  model.places->camera = {{1, 2, 3}, rotationAbout(Vec3::UnitX(), -0.5)};
  model.places->heightAngle = 0.7;
  model.places->focalDistance = 0.9;
  return model;
}

// Whether a model that was changed by `damage` is refused when it arrives.
template <typename Damage>
bool refused(Damage damage, const std::string& what) {
  Model model = scene();
  damage(model);
  return test::refuses([&] { bytesToModel(modelToBytes(model), "scene.iv"); }, what);
}

bool placesRefused(void (*damage)(ScenePlaces&), const std::string& what) {
  return refused([&](Model& model) { damage(*model.places); }, what);
}

}  // namespace

TEST_CASE("normals, finish and places cross the pipe unchanged") {
  const Model model = scene(), back = bytesToModel(modelToBytes(model), "scene.iv");
  REQUIRE(back.parts.size() == 1);
  CHECK(back.parts[0].normals == model.parts[0].normals);
  REQUIRE(back.parts[0].finish);
  CHECK(back.parts[0].finish->diffuse == model.parts[0].finish->diffuse);
  CHECK(back.parts[0].finish->specular == model.parts[0].finish->specular);
  CHECK(back.parts[0].finish->shininess == model.parts[0].finish->shininess);
  REQUIRE(back.places);
  REQUIRE(back.places->tools.size() == 2);
  CHECK(back.places->tools[0].position == model.places->tools[0].position);
  CHECK(back.places->tools[0].rotation.coeffs() == model.places->tools[0].rotation.coeffs());
  CHECK(back.places->camera.position == model.places->camera.position);
  CHECK(back.places->camera.rotation.coeffs() == model.places->camera.rotation.coeffs());
  CHECK(back.places->heightAngle == 0.7);
  CHECK(back.places->focalDistance == 0.9);
}

TEST_CASE("a message that ends early, or goes on, is refused") {
  const std::string bytes = modelToBytes(scene());
  for (std::size_t size = 0; size < bytes.size(); ++size)
    CHECK_THROWS_AS(bytesToModel(bytes.substr(0, size), "scene.iv"), Error);
  CHECK_THROWS_AS(bytesToModel(bytes + '\0', "scene.iv"), Error);
}

TEST_CASE("normals and finishes out of range are refused when they arrive") {
  CHECK(refused([](Model& m) { m.parts[0].normals.pop_back(); }, "7 normals for 8 points"));
  CHECK(refused([](Model& m) { m.parts[0].normals[1] *= 2; }, "no direction"));
  CHECK(refused([](Model& m) { m.parts[0].normals[1].x() = float(kNan); }, "no direction"));
  CHECK(refused([](Model& m) { m.parts[0].finish->shininess = 1.5f; }, "between 0 and 1"));
  CHECK(refused([](Model& m) { m.parts[0].finish->diffuse.y() = float(kNan); }, "material"));
  CHECK(refused([](Model& m) { m.parts[0].finish->specular.z() = -0.1f; }, "material"));
}

TEST_CASE("places of a saved scene out of range are refused when they arrive") {
  CHECK(placesRefused([](ScenePlaces& p) { p.camera.position.x() = kNan; }, "the camera"));
  CHECK(placesRefused([](ScenePlaces& p) { p.camera.position.z() = 1e300; }, "the camera"));
  CHECK(placesRefused([](ScenePlaces& p) { p.camera.rotation.w() = 2; }, "the camera"));
  CHECK(placesRefused([](ScenePlaces& p) { p.camera.rotation.x() = kNan; }, "the camera"));
  CHECK(placesRefused([](ScenePlaces& p) { p.tools[1].position.y() = kInfinity; }, "tool 2"));
  CHECK(placesRefused([](ScenePlaces& p) { p.tools[0].rotation.coeffs().setZero(); }, "tool 1"));
  CHECK(placesRefused([](ScenePlaces& p) { p.tools.resize(1001); }, "more than 1000 tools"));
  for (const double angle : {kNan, kInfinity, 0.0, -0.5, 3.15, 1e300}) {
    Model model = scene();
    model.places->heightAngle = angle;
    CHECK(test::refuses([&] { checkModel(model); }, "angle"));
  }
  for (const double distance : {kNan, kInfinity, 0.0, -1.0, 1e300}) {
    Model model = scene();
    model.places->focalDistance = distance;
    CHECK(test::refuses([&] { checkModel(model); }, "distance"));
  }
}

TEST_CASE("a piece with normals joins a part without, and the first piece's finish stays") {
  Model model;
  addToPart(model, "a", boxMesh({{0, 0, 0}, {1, 1, 1}}));
  ModelPart second{"a", boxMesh({{2, 0, 0}, {3, 1, 1}})};
  second.normals.assign(second.mesh.points.size(), Vec3f::UnitX());
  second.finish.emplace();
  addToPart(model, second);
  REQUIRE(model.parts.size() == 1);
  const ModelPart& part = model.parts[0];
  REQUIRE(part.normals.size() == part.mesh.points.size());
  CHECK(part.normals.front().isZero(0));
  CHECK(part.normals.back() == Vec3f::UnitX());
  CHECK_FALSE(part.finish);
  addToPart(model, "a", boxMesh({{4, 0, 0}, {5, 1, 1}}));
  CHECK(model.parts[0].normals.size() == model.parts[0].mesh.points.size());
}

TEST_CASE("parts are left out of a model, whatever else is chosen of it") {
  Model model{"m.glb", "glTF", {}};
  for (const char* name : {"wall", "lumen", "within it", "without lumen"})
    model.parts.push_back({name, sphereMesh(Vec3::Zero(), 1, 8)});
  const auto names = [&](const std::string& lines) {
    std::string all;
    for (const ModelPart& part : chosenParts(model, lines).parts) all += part.name + ";";
    return all;
  };
  std::string lines;
  leaveOut(lines, "wall");
  leaveOut(lines, "wall");
  CHECK(lines == "without wall");
  CHECK(names(lines) == "lumen;within it;without lumen;");
  CHECK(names("lumen\nwall\nwithout wall") == "lumen;");
  CHECK(names("without lumen") == "without lumen;");  // which is the name of a part
  CHECK(test::refuses([&] { names("without bone"); }, "has no part 'bone'"));
  CHECK(test::refuses([&] { names("wall\nwithout wall"); }, "no part is left"));
  const Model nameless{"m.stl", "STL", {{"", sphereMesh(Vec3::Zero(), 1, 8)}}};
  CHECK(test::refuses([&] { chosenParts(nameless, "wall"); }, "nor any part with a name"));
}
