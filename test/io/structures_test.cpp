// Structures inside an organ: tumours, and what model files bring.
#include "io/structures.h"

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <numbers>

#include "anatomy/plausible_segments.h"
#include "anatomy/structure_kind.h"
#include "anatomy/vessel_mesh.h"
#include "anatomy/visible_human.h"
#include "geometry/measures.h"
#include "geometry/primitives.h"
#include "io/scenario/scenario_file.h"
#include "organ/cell_labels.h"
#include "support/sentence.h"
#include "tissue/elastic/elastic_tissue.h"

using namespace resect;

namespace {

const std::string kStructuresStart = R"(title = "Structures"
duration = 0.1
[organ]
source = "organ.stl"
spacing = "4mm"
settle = false
rotation = { axis = [0.3, 1, 0.2], degrees = 70 }
position = [0.01, 0, -0.02]
)";

// The organ: a box of 12 x 8 x 10 cm, beside the origin of its file.
const Aabb kOrganBox{{0.1, 0.2, 0.3}, {0.22, 0.28, 0.4}};
const Vec3 kTumour(0.15, 0.24, 0.36);

VesselSegment vein() {
  return {VesselKind::PortalVein, -1, Vec3(0.11, 0.23, 0.33), Vec3(0.20, 0.25, 0.37), 0.004, true};
}

Model readShape(const std::filesystem::path& path, const std::string& /*parts*/) {
  TriangleMesh mesh;
  if (path == "organ.stl") mesh = boxMesh(kOrganBox);
  if (path == "tumour.stl") mesh = sphereMesh(kTumour, 0.015, 32);
  if (path == "lumen.stl") mesh = sphereMesh(kOrganBox.centre(), 0.03, 64);
  if (path == "mouth.stl")
    mesh = sphereMesh(Vec3(kOrganBox.centre().x(), kOrganBox.max.y(), kOrganBox.centre().z()), 0.03,
                      64);
  if (path == "elsewhere.stl") mesh = sphereMesh(Vec3(0.5, 0.5, 0.5), 0.015, 32);
  if (path == "vein.stl") mesh = vesselMesh(makeAnatomy({vein()}), VesselKind::PortalVein);
  REQUIRE(!mesh.triangles.empty());
  return {path.string(), "STL", {{"", mesh}}};
}

std::vector<OperatedOrgan> load(const std::string& text) {
  Scenario scenario = parseScenario(kStructuresStart + text, "test.toml");
  return loadOrgans(scenario, readShape);
}

// Particles of a label, and their middle.
struct Marked {
  std::int64_t particles = 0;
  Vec3 middle = Vec3::Zero();
};

Marked marked(const Discretization& cells, const std::string& name) {
  Marked result;
  for (std::int64_t i = 0; i < cells.lattice.cellCount(); ++i) {
    if (!cells.inside[std::size_t(i)] || cells.labelName(cells.labelOf(i)) != name) continue;
    ++result.particles;
    result.middle += cells.lattice.centre(cells.lattice.cell(i));
  }
  if (result.particles > 0) result.middle /= double(result.particles);
  return result;
}

const std::string kTumourFile = "[[organ.structure]]\nkind = \"tumour\"\nfile = \"tumour.stl\"\n";
const std::string kTumourBall =
    "[[organ.tumour]]\nframe = \"organ\"\ncentre = [0.8, 0.5, 0.5]\nradius = 0.012\n";

}  // namespace

TEST_CASE("a structure's file labels the particles inside it, wherever the organ lies") {
  std::optional<Pose> place;
  Scenario scenario = parseScenario(kStructuresStart + kTumourFile + kTumourBall, "test.toml");
  const Discretization cells = loadCells(scenario.organs[0].source, readShape, {}, nullptr, &place);
  REQUIRE(place);
  const double ball = 4 * std::numbers::pi / 3;
  const Marked file = marked(cells, "tumour 2"), region = marked(cells, "tumour");
  CHECK(double(file.particles) * cells.lattice.cellVolume() ==
        doctest::Approx(ball * std::pow(0.015, 3)).epsilon(0.1));
  CHECK((file.middle - *place * kTumour).norm() < 0.002);
  CHECK(double(region.particles) * cells.lattice.cellVolume() ==
        doctest::Approx(ball * std::pow(0.012, 3)).epsilon(0.15));
}

TEST_CASE("a brought vessel runs where its file says, in the organ's place") {
  const auto organs = load("[[organ.structure]]\nkind = \"portal-vein\"\nfile = \"vein.stl\"\n");
  REQUIRE(organs[0].organ.map);
  std::optional<Pose> place;
  loadOrganMesh(parseScenario(kStructuresStart, "test.toml").organs[0].source, readShape, nullptr,
                &place);
  const Vec3 start = *place * vein().start, end = *place * vein().end;
  double length = 0;
  for (const VesselSegment& s : organs[0].organ.map->anatomy.segments) {
    length += s.length();
    CHECK(s.kind == VesselKind::PortalVein);
    CHECK(s.radius == doctest::Approx(vein().radius).epsilon(0.15));
    for (const Vec3& p : {s.start, s.end})
      CHECK(segmentDistance(p, p, start, end) < 0.4 * vein().radius);
  }
  CHECK(length == doctest::Approx(vein().length()).epsilon(0.1));
}

TEST_CASE("a brought kind of vessel replaces that kind of the organ's own vessels alone") {
  const auto liver = [](const std::string& more) {
    Scenario scenario = parseScenario(
        "title = \"Liver\"\nduration = 0.1\n[organ]\nspacing = \"9mm\"\nvessels = \"built-in\"\n" +
            more,
        "test.toml");
    return loadOrgans(scenario, readShape);
  };
  const auto own = liver(""), brought = liver(
                                  "[[organ.structure]]\nkind = \"hepatic-artery\"\n"
                                  "file = \"vein.stl\"\n");
  const Anatomy& a = own[0].organ.map->anatomy;
  const Anatomy& b = brought[0].organ.map->anatomy;
  for (const VesselKind kind :
       {VesselKind::PortalVein, VesselKind::HepaticVein, VesselKind::BileDuct}) {
    CHECK(b.range(kind).count == a.range(kind).count);
    for (int i = 0; i < a.range(kind).count; ++i)
      CHECK(b.segments[std::size_t(b.range(kind).first + i)].end ==
            a.segments[std::size_t(a.range(kind).first + i)].end);
  }
  CHECK(b.range(VesselKind::HepaticArtery).count < 40);
  CHECK(a.range(VesselKind::HepaticArtery).count > 500);
}

TEST_CASE("tumours are stiffer than their organ, unless their material is given") {
  const auto substep = [](const std::string& more) {
    const auto organs = load(kTumourBall + "[tissue]\nmodel = \"elastic\"\nyoung = 5000\n" + more);
    return dynamic_cast<const ElasticTissue&>(*organs[0].tissue).longestSubstep();
  };
  const double own = substep("[[tissue.material]]\nlabel = 1\n"), stiff = substep("");
  // Waves are faster by the root of the stiffness, of which the branches have no part.
  CHECK(own / stiff > 1.2);
  CHECK(own / stiff < std::sqrt(3.0) + 0.01);
}

TEST_CASE("structures that cannot be used are refused in a sentence") {
  const auto refused = [](const std::string& text, const std::string& tells) {
    const std::string sentence = test::sentenceOf([&] { load(text); });
    CHECK_MESSAGE(test::isOneSentence(sentence), sentence);
    CHECK_MESSAGE(test::tells(sentence, tells), sentence);
  };
  refused("[[organ.structure]]\nkind = \"tumour\"\nfile = \"elsewhere.stl\"\n", "check its unit");
  refused("[[organ.structure]]\nkind = \"tumour\"\nfile = \"tumour.stl\"\nunit = \"mm\"\n",
          "check its unit");
  refused("[[organ.structure]]\nkind = \"portal-vein\"\nfile = \"vein.stl\"\nunit = \"mm\"\n",
          "check its unit");
  refused("[[organ.structure]]\nkind = \"spleen\"\nfile = \"tumour.stl\"\n", "portal-vein");
  refused("[[organ.structure]]\nkind = \"parenchyma\"\nfile = \"tumour.stl\"\n",
          "use one of tumour, cyst");
  refused("[[organ.structure]]\nkind = \"portal-vein\"\n", "file");
  refused("[[organ.structure]]\nkind = \"tumour\"\n", "centre and radius");
  refused("[[organ.tumour]]\ncentre = [0, 0.04, 0]\nradius = 0.01\nkind = \"cyst\"\n", "kind");
}

TEST_CASE("no tissue lies in a cavity, also where it reaches out of the organ") {
  const auto load = [](const std::string& text, std::vector<std::string>* notes = nullptr) {
    return loadCells(parseScenario(kStructuresStart + text, "test.toml").organs[0].source,
                     readShape, {}, notes);
  };
  const auto tissue = [](const Discretization& cells) {
    double ml = 0;
    for (std::int64_t i = 0; i < cells.lattice.cellCount(); ++i)
      ml += cells.inside[std::size_t(i)] ? 1e6 * cells.lattice.cellVolume() : 0;
    return ml;
  };
  const auto cavity = [](const std::string& file) {
    return "[[organ.structure]]\nkind = \"cavity\"\nfile = \"" + file + "\"\n";
  };
  const double ball = 1e6 * 4 * std::numbers::pi / 3 * std::pow(0.03, 3);  // ml
  const double whole = tissue(load(""));
  CHECK(whole == doctest::Approx(960).epsilon(0.01));
  std::vector<std::string> notes;
  CHECK(whole - tissue(load(cavity("lumen.stl"), &notes)) == doctest::Approx(ball).epsilon(0.02));
  REQUIRE_FALSE(notes.empty());
  CHECK(notes[0].starts_with("lumen.stl: a cavity of 11"));
  // Half of the ball lies outside, and no tissue comes into being there.
  CHECK(whole - tissue(load(cavity("mouth.stl"))) == doctest::Approx(ball / 2).epsilon(0.03));
  CHECK(whole - tissue(load(cavity("lumen.stl") + cavity("lumen.stl"))) ==
        doctest::Approx(ball).epsilon(0.02));
  CHECK(test::refuses([&] { load(cavity("elsewhere.stl")); }, "where the organ has no tissue"));
}

TEST_CASE("a cavity that is a part of the organ's own file is no part of the organ's body") {
  const auto readParts = [](const std::filesystem::path& path, const std::string&) {
    return Model{path.string(),
                 "glTF",
                 {{"wall", boxMesh(kOrganBox)},
                  {"lumen", sphereMesh(kOrganBox.centre(), 0.03, 64)},
                  {"tumour", sphereMesh(kTumour, 0.012, 32)}}};
  };
  const std::string cavity =
      "[[organ.structure]]\nkind = \"cavity\"\nfile = \"organ.stl\"\npart = \"lumen\"\n";
  Scenario scenario = parseScenario(kStructuresStart + cavity, "test.toml");
  OrganSource& source = scenario.organs[0].source;
  CHECK(source.part == "without lumen");
  const double ball = 4 * std::numbers::pi / 3 * std::pow(0.03, 3);
  const double box = kOrganBox.size().prod();
  CHECK(volume(loadOrganMesh(source, readParts)) ==
        doctest::Approx(box - ball + volume(sphereMesh(kTumour, 0.012, 32))).epsilon(1e-3));
  std::vector<std::string> notes;
  loadOrganMesh(source, readParts, &notes);
  CHECK(test::tells(fmt::format("{}", fmt::join(notes, "\n")), "facing outwards (part 'tumour')"));
  notes.clear();
  loadOrganMesh(parseScenario(kStructuresStart, "test.toml").organs[0].source, readParts, &notes);
  CHECK(test::tells(fmt::format("{}", fmt::join(notes, "\n")),
                    "roles by --structure cavity=lumen --structure tumour=tumour"));
  const std::string tumour =
      "[[organ.structure]]\nkind = \"tumour\"\nfile = \"organ.stl\"\npart = \"tumour\"\n";
  notes.clear();
  loadOrganMesh(parseScenario(kStructuresStart + cavity + tumour, "test.toml").organs[0].source,
                readParts, &notes);
  CHECK_FALSE(test::tells(fmt::format("{}", fmt::join(notes, "\n")), "facing outwards"));
  source.part = "wall\nwithout lumen";
  CHECK(volume(loadOrganMesh(source, readParts)) == doctest::Approx(box - ball).epsilon(1e-3));
}

TEST_CASE("the segments of a liver with brought veins are plausible") {
  const auto liver = test::visibleHumanLiver();
  const auto portal = test::sharedData("visible-human-male/VH_M_portal.obj");
  const auto hepatic = test::sharedData("visible-human-male/VH_M_hepatic_veins.obj");
  if (!liver || !portal || !hepatic) return;
  OrganSource source;
  source.structures = {{*structureKind("portal-vein"), 0, "", portal->string(), "", 1},
                       {*structureKind("hepatic-vein"), 0, "", hepatic->string(), "", 1}};
  const ModelReader reader = [](const std::filesystem::path& path, const std::string&) {
    return Model{path.string(), "OBJ", {{"", test::readPlainObj(path.string())}}};
  };
  test::checkPlausible(vesselsOf(source, Pose(), *liver, reader, nullptr)->anatomy, *liver);
}
