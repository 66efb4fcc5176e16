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

Model modelOfParts(std::initializer_list<ModelPart> parts) {
  Model model;
  model.path = "organ.obj";
  model.format = "OBJ";
  model.parts = parts;
  return model;
}

TriangleMesh closedBall() { return sphereMesh({0, 0, 0}, 0.1); }

TriangleMesh openBall() {
  TriangleMesh mesh = closedBall();
  mesh.triangles.erase(mesh.triangles.begin() + 100);
  return mesh;
}

std::string sentenceOfMesh(const Model& model, const OrganMeshOptions& options = {}) {
  return test::sentenceOf([&] { prepareOrganMesh(model, options); });
}

}  // namespace

TEST_CASE("a sound ball passes unchanged and without notes") {
  const OrganMesh organ = prepareOrganMesh(modelOfParts({{"ball", closedBall()}}));
  CHECK(organ.mesh.points == closedBall().points);
  CHECK(organ.mesh.triangles == closedBall().triangles);
  CHECK(organ.notes.empty());
  CHECK(organ.health.closed);
}

TEST_CASE("a ball inside out is turned, and that is said") {
  TriangleMesh mesh = closedBall();
  flip(mesh);
  const OrganMesh organ = prepareOrganMesh(modelOfParts({{"", mesh}}));
  CHECK(volume(organ.mesh) == doctest::Approx(volume(closedBall())));
  REQUIRE(organ.notes.size() == 1);
  CHECK(test::tells(organ.notes[0], "inside out"));
}

TEST_CASE("triangles that disagree are turned") {
  TriangleMesh mesh = closedBall();
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3)
    std::swap(mesh.triangles[i][0], mesh.triangles[i][1]);
  const OrganMesh organ = prepareOrganMesh(modelOfParts({{"", mesh}}));
  CHECK(organ.health.oriented);
  CHECK(volume(organ.mesh) == doctest::Approx(volume(closedBall())));
}

TEST_CASE("an open ball is refused with its edges and the place of the first, unless repaired") {
  const Model model = modelOfParts({{"", openBall()}});
  const std::string text = sentenceOfMesh(model);
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
  CHECK(volume(organ.mesh) == doctest::Approx(volume(closedBall())));
  REQUIRE(organ.notes.size() == 1);
  CHECK(test::tells(organ.notes[0], "1 hole closed with 1 triangle"));
  CHECK(test::tells(organ.notes[0], "changed the volume by +"));
  // In per cent of the volume before, from the middle of the box.
  const double before = volumeAbout(openBall(), bounds(openBall()).centre());
  CHECK(test::tells(organ.notes[0],
                    fmt::format("({:+.3g} %)", 100 * (volume(closedBall()) / before - 1))));
}

TEST_CASE("parts that make no body together are listed, and one can be chosen") {
  const Model model =
      modelOfParts({{"capsule", openBall()}, {"stone", boxMesh({{0, 0, 0}, {0.02, 0.02, 0.03}})}});
  const std::string text = sentenceOfMesh(model);
  CHECK(test::tells(text, "its 2 parts together"));
  CHECK(test::tells(text, "capsule, stone"));
  OrganMeshOptions options;
  options.part = "stone";
  CHECK(volume(prepareOrganMesh(model, options).mesh) == doctest::Approx(0.02 * 0.02 * 0.03));
  options.part = "gall";
  CHECK(
      test::tells(sentenceOfMesh(model, options), "no part 'gall'; choose one of: capsule, stone"));
  options.part = partLines({"stone", "gall"});
  CHECK(
      test::tells(sentenceOfMesh(model, options), "no part 'gall'; choose one of: capsule, stone"));
}

TEST_CASE("several parts are joined to one body") {
  TriangleMesh capsule = boxMesh({{0, 0, 0}, {0.1, 0.1, 0.1}}), bare = capsule;
  capsule.triangles.resize(10);
  bare.triangles.erase(bare.triangles.begin(), bare.triangles.begin() + 10);
  const TriangleMesh sheet{{{0.05, 0.02, 0.02}, {0.05, 0.08, 0.02}, {0.05, 0.05, 0.08}},
                           {{0, 1, 2}}};
  const Model model =
      modelOfParts({{"capsule", capsule}, {"bare area", bare}, {"sheet inside", sheet}});
  CHECK(test::tells(sentenceOfMesh(model),
                    "choose some with --part, which may be given several times"));
  OrganMeshOptions options;
  options.part = "capsule\nbare area";
  const OrganMesh organ = prepareOrganMesh(model, options);
  CHECK(organ.volume == doctest::Approx(0.001));
  CHECK(organ.notes.empty());
  options.part = "bare area\nsheet inside";
  CHECK(test::tells(sentenceOfMesh(model, options),
                    "its 2 chosen parts together are no closed body"));
  CHECK(partNames(options.part) == std::vector<std::string>{"bare area", "sheet inside"});
  CHECK(partNames("").empty());
  CHECK(chosenParts(model, "").parts.size() == 3);
}

TEST_CASE("inner shells are told: cavities, and those that face outwards, with their part") {
  TriangleMesh inner = boxMesh({{0.03, 0.03, 0.03}, {0.07, 0.07, 0.07}});
  const TriangleMesh outer = boxMesh({{0, 0, 0}, {0.1, 0.1, 0.1}});
  OrganMesh organ = prepareOrganMesh(modelOfParts({{"liver", outer}, {"tumour", inner}}));
  CHECK(organ.volume == doctest::Approx(1e-3));
  CHECK(organ.mesh.triangles.size() == outer.triangles.size());  // the shell bounds no tissue
  REQUIRE(organ.notes.size() == 1);
  CHECK(organ.notes[0] ==
        "1 inner shell of 64 ml facing outwards (part 'tumour'): what it encloses is tissue; give "
        "a part that is a cavity or a tumour this role (--structure cavity=PART)");
  organ = prepareOrganMesh(modelOfParts({{"liver", outer}, {"tumour", inner}}),
                           {"", false, 1, "tumour"});
  CHECK(organ.notes.empty());
  flip(inner);
  TriangleMesh both = outer;
  append(both, inner);
  organ = prepareOrganMesh(modelOfParts({{"", both}}));
  CHECK(organ.volume == doctest::Approx(936e-6));
  REQUIRE(organ.notes.size() == 2);
  CHECK(
      organ.notes[1] ==
      "1 inner shell of 64 ml facing inwards: a cavity without tissue (the one round (0.05, 0.05, "
      "0.05) m)");
  append(both, sphereMesh({0.015, 0.015, 0.015}, 0.01, 8));
  append(both, sphereMesh({0.085, 0.015, 0.015}, 0.012, 8));
  organ = prepareOrganMesh(modelOfParts({{"", both}}));
  REQUIRE(organ.notes.size() == 3);
  CHECK(test::tells(organ.notes[2], "2 inner shells of"));
  CHECK(test::tells(organ.notes[2], "(the largest is the one round (0.085, 0.015, 0.015) m)"));
}

TEST_CASE("components that reach into each other are told, others are not") {
  const TriangleMesh a = sphereMesh(Vec3::Zero(), 0.03, 32);
  TriangleMesh apart = a, through = a, within = a;
  append(apart, sphereMesh({0.07, 0, 0}, 0.03, 32));
  append(through, sphereMesh({0.04, 0, 0}, 0.03, 32));
  append(within, sphereMesh({0.005, 0, 0}, 0.01, 32));
  const auto notes = [](const TriangleMesh& mesh) {
    std::string all;
    for (const std::string& note : prepareOrganMesh(modelOfParts({{"", mesh}})).notes) all += note;
    return all;
  };
  CHECK(test::tells(notes(through), "2 components reach into others"));
  CHECK_FALSE(test::tells(notes(apart), "into others"));
  CHECK_FALSE(test::tells(notes(within), "into others"));
}

TEST_CASE("a .3mf tells its unit itself, and another one is refused") {
  Model model = modelOfParts({{"ball", closedBall()}});
  model.format = "3MF";
  CHECK(test::tells(sentenceOfMesh(model, {"", false, 0.001}), "tells its unit itself"));
}

TEST_CASE("a face and its back are one face, and that is said") {
  TriangleMesh mesh = closedBall(), back = closedBall();
  flip(back);
  append(mesh, back);
  const OrganMesh organ = prepareOrganMesh(modelOfParts({{"", mesh}}));
  CHECK(organ.volume == doctest::Approx(volume(closedBall())));
  CHECK(organ.health.triangles == int(closedBall().triangles.size()));
  REQUIRE(organ.notes.size() == 1);
  CHECK(test::tells(organ.notes[0], "every face was there more than once"));
  // Two parts that are the same.
  CHECK(prepareOrganMesh(modelOfParts({{"a", closedBall()}, {"b", closedBall()}})).volume ==
        doctest::Approx(volume(closedBall())));
}

TEST_CASE("overlapping parts are not repaired into nonsense") {
  TriangleMesh twice = openBall();
  const Model model = modelOfParts({{"a", twice}, {"b", twice}, {"c", openBall()}});
  OrganMeshOptions options;
  options.repair = true;
  CHECK(test::tells(sentenceOfMesh(model, options), "a, b, c"));
}

TEST_CASE("two halves that share a rim are one body") {
  TriangleMesh upper = closedBall(), lower = closedBall();
  upper.triangles.resize(700);
  lower.triangles.erase(lower.triangles.begin(), lower.triangles.begin() + 700);
  const OrganMesh organ = prepareOrganMesh(modelOfParts({{"upper", upper}, {"lower", lower}}));
  CHECK(organ.health.components == 1);
  CHECK(volume(organ.mesh) == doctest::Approx(volume(closedBall())));
}

TEST_CASE("copies that meet up to rounding are welded, gaps are not") {
  TriangleMesh half = closedBall();
  TriangleMesh lower = half;
  half.triangles.resize(700);
  lower.triangles.erase(lower.triangles.begin(), lower.triangles.begin() + 700);
  for (Vec3& p : lower.points) p += Vec3(1e-9, -1e-9, 1e-9);
  CHECK(prepareOrganMesh(modelOfParts({{"a", half}, {"b", lower}})).health.closed);
  for (Vec3& p : lower.points) p += Vec3(1e-5, 0, 0);
  CHECK(test::tells(sentenceOfMesh(modelOfParts({{"a", half}, {"b", lower}})), "boundary edges"));
}

TEST_CASE("units scale the surface, and an implausible size is noted with the likely unit") {
  TriangleMesh millimetres = closedBall();
  for (Vec3& p : millimetres.points) p *= 1000;
  const Model model = modelOfParts({{"", millimetres}});
  const OrganMesh raw = prepareOrganMesh(model);
  REQUIRE(raw.notes.size() == 1);
  CHECK(raw.notes[0] ==
        "its longest side is 200 m, which is no organ's; in mm it would be 0.2 m: add --unit mm");
  OrganMeshOptions options;
  options.metresPerUnit = 0.001;
  const OrganMesh scaled = prepareOrganMesh(model, options);
  CHECK(scaled.notes.empty());
  CHECK(volume(scaled.mesh) == doctest::Approx(volume(closedBall())));
}

TEST_CASE("plausible units bring a body to the size of a liver") {
  const auto box = [](double side) { return Aabb{{0, 0, 0}, {side, side / 2, side / 3}}; };
  CHECK(plausibleUnit(box(0.2)) == "m");
  CHECK(plausibleUnit(box(19)) == "cm");
  CHECK(plausibleUnit(box(210)) == "mm");
  CHECK(plausibleUnit(box(2e5)) == "um");
  CHECK(plausibleUnit(box(0)) == "");
  CHECK(isOrganSized(box(0.3)));
  CHECK_FALSE(isOrganSized(box(20)));
}

TEST_CASE("a doubt about the size names the unit that would do, or none") {
  const auto doubt = [](double side, double metresPerUnit) {
    return sizeDoubt({Vec3::Zero(), Vec3(side, side / 2, side / 3)}, metresPerUnit);
  };
  CHECK(doubt(0.2, 1).empty());
  CHECK(test::tells(doubt(200, 1), "in mm it would be 0.2 m: add --unit mm"));
  CHECK(test::tells(doubt(15, 1), "add --unit cm"));
  // In mm already, but its numbers are metres.
  CHECK(test::tells(doubt(2e-4, 1e-3), "in m it would be 0.2 m: add --unit m"));
  CHECK(test::tells(doubt(1.5, 1), "scale it"));
  CHECK(test::tells(doubt(0, 1), "scale it"));
  const Error refused = usageError("too many cells");
  CHECK(withDoubt(refused, "").what() == std::string("too many cells"));
  const Error doubted = withDoubt(refused, doubt(200, 1));
  CHECK(test::tells(doubted.what(), "too many cells; its longest side is 200 m"));
  CHECK(doubted.status() == Error::Status::Usage);
  CHECK(withDoubt(doubted, doubt(200, 1)).what() == std::string(doubted.what()));
}

TEST_CASE("an open surface in another unit is refused with the unit that would do") {
  TriangleMesh millimetres = openBall();
  for (Vec3& p : millimetres.points) p *= 1000;
  CHECK(test::tells(sentenceOfMesh(modelOfParts({{"", millimetres}})), "add --unit mm"));
}

TEST_CASE("specks and bodies without volume") {
  Model model = modelOfParts({{"", closedBall()}});
  append(model.parts[0].mesh, {{{1, 0, 0}, {2, 0, 0}, {1, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}});
  const OrganMesh organ = prepareOrganMesh(model);
  CHECK(organ.repairs.specksDropped == 1);
  CHECK(organ.health.components == 1);
  model.parts[0].mesh = {{{1, 0, 0}, {2, 0, 0}, {1, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}};
  CHECK(test::tells(sentenceOfMesh(model), "encloses no volume"));
  model.parts[0].mesh = {{{1, 0, 0}, {1, 0, 0}, {1, 0, 0}}, {{0, 1, 2}}};
  CHECK(test::tells(sentenceOfMesh(model), "degenerate"));
}

TEST_CASE("the report has the promised fields, as read and after welding") {
  TriangleMesh mesh = openBall();
  mesh.points.push_back({9, 9, 9});  // belongs to no triangle
  const ModelInfo info =
      modelInfo(modelOfParts({{"a", mesh}, {"b", boxMesh({{1, 1, 1}, {2, 2, 2}})}}));
  const nlohmann::ordered_json json = toJson(info);
  CHECK(json["triangles"] == int(mesh.triangles.size()) + 12);
  CHECK(json["vertices"] == int(closedBall().points.size()) + 8);
  CHECK(json["area_m2"].get<double>() == doctest::Approx(area(openBall()) + 6));
  CHECK(json["volume_ml"].get<double>() == doctest::Approx(volume(openBall()) * 1e6 + 1e6));
  CHECK(json["bounds_m"][1][0] == 2.0);
  CHECK(json["components"] == 2);
  CHECK(json["closed"] == false);
  CHECK(json["oriented"] == true);  // open, but wound one way
  CHECK(json["inside_out"] == false);
  CHECK(json["boundary_edges"] == 3);
  CHECK(json["parts"] == std::vector<std::string>{"a", "b"});
  CHECK(json["part_health"][0]["closed"] == false);
  CHECK(json["part_health"][0]["boundary_edges"] == 3);
  CHECK(json["part_health"][0]["volume_ml"].is_null());
  CHECK(json["part_health"][1]["volume_ml"].get<double>() == doctest::Approx(1e6));
  CHECK(json["organ_ml"].is_null());
  CHECK(test::tells(json["refusal"].get<std::string>(), "its 2 parts together"));
  CHECK(test::tells(toText(info), "no, 3 boundary edges"));
  CHECK(test::tells(toText(info), "refused: its 2 parts together"));
  CHECK(test::tells(toText(info), "b: 12 triangles, closed, 1e+06 ml"));
}

TEST_CASE("the report says what organ a model becomes, in its unit and of its parts") {
  TriangleMesh hollow = boxMesh({{0, 0, 0}, {100, 100, 100}});
  append(hollow, boxMesh({{30, 30, 30}, {70, 70, 70}}));
  const Model model = modelOfParts({{"bladder", hollow}, {"stone", closedBall()}});
  const ModelInfo info = modelInfo(model, {"bladder", false, 1e-3});
  REQUIRE(info.parts.size() == 1);
  REQUIRE(info.organVolume);
  CHECK(*info.organVolume == doctest::Approx(1e-3));
  CHECK(info.volume == doctest::Approx(1.064e-3));
  CHECK(info.unitHint.empty());
  CHECK(test::tells(toText(info), "facing outwards"));
  CHECK(toJson(info)["organ_ml"].get<double>() == doctest::Approx(1000));
  CHECK(modelInfo(model, {"bladder", false, 1}).unitHint == "mm");
  CHECK(modelInfo(model, {"bladder", false, 1e-6}).unitHint == "mm");
}

TEST_CASE("a model crosses the pipe unchanged, and damage is noticed") {
  const Model model = modelOfParts({{"a", closedBall()}, {"", boxMesh({{0, 0, 0}, {1, 1, 1}})}});
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
