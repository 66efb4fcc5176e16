#include "io/organ_mesh.h"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "formats/model_info.h"
#include "geometry/measures.h"
#include "geometry/primitives.h"
#include "geometry/topology.h"
#include "io/organ_size.h"
#include "support/sentence.h"

using namespace resect;

namespace {

Model modelOf(std::initializer_list<ModelPart> parts) {
  Model model;
  model.path = "organ.obj";
  model.format = "OBJ";
  model.parts = parts;
  return model;
}

TriangleMesh ball() { return sphereMesh({0, 0, 0}, 0.1); }

TriangleMesh openBall() {
  TriangleMesh mesh = ball();
  mesh.triangles.erase(mesh.triangles.begin() + 100);
  return mesh;
}

std::string sentence(const Model& model, const OrganMeshOptions& options = {}) {
  return test::sentenceOf([&] { prepareOrganMesh(model, options); });
}

}  // namespace

TEST_CASE("a sound ball passes unchanged and without notes") {
  const OrganMesh organ = prepareOrganMesh(modelOf({{"ball", ball()}}));
  CHECK(organ.mesh.points == ball().points);
  CHECK(organ.mesh.triangles == ball().triangles);
  CHECK(organ.notes.empty());
  CHECK(organ.health.closed);
}

TEST_CASE("a ball inside out is turned, and that is said") {
  TriangleMesh mesh = ball();
  flip(mesh);
  const OrganMesh organ = prepareOrganMesh(modelOf({{"", mesh}}));
  CHECK(volume(organ.mesh) == doctest::Approx(volume(ball())));
  REQUIRE(organ.notes.size() == 1);
  CHECK(test::tells(organ.notes[0], "inside out"));
}

TEST_CASE("triangles that disagree are turned") {
  TriangleMesh mesh = ball();
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3)
    std::swap(mesh.triangles[i][0], mesh.triangles[i][1]);
  const OrganMesh organ = prepareOrganMesh(modelOf({{"", mesh}}));
  CHECK(organ.health.oriented);
  CHECK(volume(organ.mesh) == doctest::Approx(volume(ball())));
}

TEST_CASE("an open ball is refused with its edges and the place of the first, unless repaired") {
  const Model model = modelOf({{"", openBall()}});
  const std::string text = sentence(model);
  CHECK(test::tells(text, "organ.obj: "));
  CHECK(test::tells(text, "3 boundary edges"));
  CHECK(test::tells(text, "--repair"));
  const Vec3 first = *topology(openBall()).firstBoundaryPoint;
  CHECK(
      test::tells(text, fmt::format("({:.6g}, {:.6g}, {:.6g})", first.x(), first.y(), first.z())));

  OrganMeshOptions options;
  options.repair = true;
  const OrganMesh organ = prepareOrganMesh(model, options);
  CHECK(organ.health.closed);
  CHECK(volume(organ.mesh) == doctest::Approx(volume(ball())));
  REQUIRE(organ.notes.size() == 1);
  CHECK(test::tells(organ.notes[0], "1 hole closed with 1 triangle"));
  CHECK(test::tells(organ.notes[0], "changed the volume by +"));
}

TEST_CASE("parts that make no body together are listed, and one can be chosen") {
  const Model model =
      modelOf({{"capsule", openBall()}, {"stone", boxMesh({{0, 0, 0}, {0.02, 0.02, 0.03}})}});
  const std::string text = sentence(model);
  CHECK(test::tells(text, "its 2 parts together"));
  CHECK(test::tells(text, "capsule, stone"));
  OrganMeshOptions options;
  options.part = "stone";
  CHECK(volume(prepareOrganMesh(model, options).mesh) == doctest::Approx(0.02 * 0.02 * 0.03));
  options.part = "gall";
  CHECK(test::tells(sentence(model, options), "no part 'gall'; choose one of: capsule, stone"));
}

TEST_CASE("overlapping parts are not repaired into nonsense") {
  TriangleMesh twice = openBall();
  const Model model = modelOf({{"a", twice}, {"b", twice}, {"c", openBall()}});
  OrganMeshOptions options;
  options.repair = true;
  CHECK(test::tells(sentence(model, options), "a, b, c"));
}

TEST_CASE("two halves that share a rim are one body") {
  TriangleMesh upper = ball(), lower = ball();
  upper.triangles.resize(700);
  lower.triangles.erase(lower.triangles.begin(), lower.triangles.begin() + 700);
  const OrganMesh organ = prepareOrganMesh(modelOf({{"upper", upper}, {"lower", lower}}));
  CHECK(organ.health.components == 1);
  CHECK(volume(organ.mesh) == doctest::Approx(volume(ball())));
}

TEST_CASE("copies that meet up to rounding are welded, gaps are not") {
  TriangleMesh half = ball();
  TriangleMesh lower = half;
  half.triangles.resize(700);
  lower.triangles.erase(lower.triangles.begin(), lower.triangles.begin() + 700);
  for (Vec3& p : lower.points) p += Vec3(1e-9, -1e-9, 1e-9);
  CHECK(prepareOrganMesh(modelOf({{"a", half}, {"b", lower}})).health.closed);
  for (Vec3& p : lower.points) p += Vec3(1e-5, 0, 0);
  CHECK(test::tells(sentence(modelOf({{"a", half}, {"b", lower}})), "boundary edges"));
}

TEST_CASE("units scale the surface, and an implausible size is noted with the likely unit") {
  TriangleMesh millimetres = ball();
  for (Vec3& p : millimetres.points) p *= 1000;
  const Model model = modelOf({{"", millimetres}});
  const OrganMesh raw = prepareOrganMesh(model);
  REQUIRE(raw.notes.size() == 1);
  CHECK(test::tells(raw.notes[0], "perhaps the file is in mm"));
  OrganMeshOptions options;
  options.metresPerUnit = 0.001;
  const OrganMesh scaled = prepareOrganMesh(model, options);
  CHECK(scaled.notes.empty());
  CHECK(volume(scaled.mesh) == doctest::Approx(volume(ball())));
}

TEST_CASE("plausible units bring a body to the size of a liver") {
  const auto box = [](double side) { return Aabb{{0, 0, 0}, {side, side / 2, side / 3}}; };
  CHECK(plausibleUnit(box(0.2)) == "m");
  CHECK(plausibleUnit(box(19)) == "cm");
  CHECK(plausibleUnit(box(210)) == "mm");
  CHECK(plausibleUnit(box(0)) == "");
  CHECK(isOrganSized(box(0.3)));
  CHECK_FALSE(isOrganSized(box(20)));
}

TEST_CASE("specks and bodies without volume") {
  Model model = modelOf({{"", ball()}});
  append(model.parts[0].mesh, {{{1, 0, 0}, {2, 0, 0}, {1, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}});
  const OrganMesh organ = prepareOrganMesh(model);
  CHECK(organ.repairs.specksDropped == 1);
  CHECK(organ.health.components == 1);
  model.parts[0].mesh = {{{1, 0, 0}, {2, 0, 0}, {1, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}};
  CHECK(test::tells(sentence(model), "encloses no volume"));
  model.parts[0].mesh = {{{1, 0, 0}, {1, 0, 0}, {1, 0, 0}}, {{0, 1, 2}}};
  CHECK(test::tells(sentence(model), "degenerate"));
}

TEST_CASE("the report has the promised fields, as read and after welding") {
  TriangleMesh mesh = openBall();
  mesh.points.push_back({9, 9, 9});  // belongs to no triangle
  const ModelInfo info = modelInfo(modelOf({{"a", mesh}, {"b", boxMesh({{1, 1, 1}, {2, 2, 2}})}}));
  const nlohmann::ordered_json json = toJson(info);
  CHECK(json["triangles"] == int(mesh.triangles.size()) + 12);
  CHECK(json["vertices"] == int(ball().points.size()) + 8);
  CHECK(json["area_m2"].get<double>() == doctest::Approx(area(openBall()) + 6));
  CHECK(json["volume_ml"].get<double>() == doctest::Approx(volume(openBall()) * 1e6 + 1e6));
  CHECK(json["bounds_m"][1][0] == 2.0);
  CHECK(json["components"] == 2);
  CHECK(json["closed"] == false);
  CHECK(json["oriented"] == true);  // open, but wound one way
  CHECK(json["inside_out"] == false);
  CHECK(json["boundary_edges"] == 3);
  CHECK(json["parts"] == std::vector<std::string>{"a", "b"});
  CHECK(test::tells(toText(info), "no, 3 boundary edges"));
}

TEST_CASE("a model crosses the pipe unchanged, and damage is noticed") {
  const Model model = modelOf({{"a", ball()}, {"", boxMesh({{0, 0, 0}, {1, 1, 1}})}});
  const std::string bytes = modelToBytes(model);
  const Model back = bytesToModel(bytes, "organ.obj");
  REQUIRE(back.parts.size() == 2);
  CHECK(back.format == "OBJ");
  for (int i = 0; i < 2; ++i) {
    CHECK(back.parts[i].name == model.parts[i].name);
    CHECK(back.parts[i].mesh.points == model.parts[i].mesh.points);
    CHECK(back.parts[i].mesh.triangles == model.parts[i].mesh.triangles);
  }
  for (std::size_t length = 0; length < bytes.size(); length += 577)
    CHECK_THROWS_AS(bytesToModel(bytes.substr(0, length), "x"), Error);
  CHECK_THROWS_AS(bytesToModel(bytes + "x", "x"), Error);
  Model bad = model;
  bad.parts[0].mesh.triangles[3][1] = 1'000'000;
  CHECK_THROWS_AS(bytesToModel(modelToBytes(bad), "x"), Error);
  bad = model;
  bad.parts[0].mesh.points[3].y() = std::nan("");
  CHECK_THROWS_AS(bytesToModel(modelToBytes(bad), "x"), Error);
}
