#include "io/scenario/label_reader.h"

#include <doctest/doctest.h>

#include "base/error.h"
#include "io/cells/particle_file.h"
#include "io/operation_setup.h"
#include "io/scenario/scenario_file.h"
#include "operation/run.h"
#include "organ/cell_labels.h"
#include "support/malformed/refused_scenario.h"
#include "support/sentence.h"
#include "support/temporary_folder.h"
#include "tissue/elastic/elastic_tissue.h"

using namespace resect;
using test::complaintOfScenario;

namespace {

const std::string kLabelsStart = R"(title = "Labels"
duration = 0.1
[organ]
spacing = "10mm"
)";

const std::string kLabels = R"([organ.landmark]
fundus = [0.5, 0.5, 0.5]
[[organ.label]]
label = 7
name = "tumour"
at = "fundus"
radius = 0.03
[[organ.label]]
label = 9
frame = "organ"
box = [[0, 0, 0], [0.25, 1, 1]]
)";

const std::string kMaterials = R"([tissue]
model = "elastic"
density = 1000
[[tissue.material]]
label = 7
name = "hard"
young = 20000
density = 1500
)";

std::string complaintOfSetup(const std::string& text) {
  return test::sentenceOf([&] {
    Scenario scenario = parseScenario(text, "x.toml");
    makeSimulation(scenario, {});
  });
}

}  // namespace

TEST_CASE("a scenario says which cells are labelled and what labels are of") {
  const Scenario s = parseScenario(kLabelsStart + kLabels + kMaterials, "x.toml");
  REQUIRE(s.organs[0].source.labels.size() == 2);
  CHECK(s.organs[0].source.labels[0].label == 7);
  CHECK(s.organs[0].source.labels[0].name == "tumour");
  CHECK(s.organs[0].source.labels[0].region.landmark == "fundus");
  CHECK(s.organs[0].source.labels[0].region.shape == Region::Shape::Ball);
  CHECK(s.organs[0].source.labels[1].region.frame == Region::Frame::Organ);
  REQUIRE(s.organs[0].source.landmarks.size() == 1);
  CHECK(s.organs[0].source.landmarks[0].place == Vec3(0.5, 0.5, 0.5));
  CHECK(s.organs[0].tissue.materialOf(7).young == 20000);
  CHECK(s.organs[0].tissue.materialOf(7).poisson == s.organs[0].tissue.material.poisson);
  CHECK(s.organs[0].tissue.materialOf(7).name == "hard");
  CHECK(s.organs[0].tissue.materialOf(9).density == 1000);
  CHECK(s.organs[0].tissue.materialOf(0).density == 1000);
}

TEST_CASE("a wrong region, label or material is refused with its line and key") {
  const std::string label = "[[organ.label]]\nlabel = 1\n";
  CHECK(
      test::tells(complaintOfScenario(kLabelsStart + label), "box is missing or not two corners"));
  CHECK(test::tells(complaintOfScenario(kLabelsStart + "[[organ.label]]\ndepth = [0, 1]\n"),
                    "label is missing"));
  CHECK(test::tells(
      complaintOfScenario(kLabelsStart + "[[organ.label]]\nlabel = 0\ndepth = [0, 1]\n"),
      "x.toml:6: organ.label[1].label is no whole number from 1 to 255"));
  CHECK(test::tells(complaintOfScenario(kLabelsStart + label + "centre = [0, 0, 0]\n"),
                    "radius is missing"));
  CHECK(test::tells(
      complaintOfScenario(kLabelsStart + label + "at = \"a\"\ncentre = [0, 0, 0]\nradius = 0.1\n"),
      "keep one of"));
  CHECK(test::tells(complaintOfScenario(kLabelsStart + label + "radius = 0.1\n"),
                    "belongs to a ball"));
  CHECK(test::tells(complaintOfScenario(kLabelsStart + label + "depth = [0.1, 0]\n"),
                    "the lesser first"));
  CHECK(test::tells(complaintOfScenario(kLabelsStart + label + "depth = [0, inf]\n"),
                    "no number from 0 to 10"));
  CHECK(
      test::tells(complaintOfScenario(kLabelsStart + label + "depth = 3\n"), "no list of numbers"));
  CHECK(
      test::tells(complaintOfScenario(kLabelsStart + label + "depth = [0, 1]\nframe = \"organ\"\n"),
                  "leave it out"));
  CHECK(test::tells(complaintOfScenario(kLabelsStart + label + "depth = [0, 1]\nbax = 1\n"),
                    "is not known here"));
  CHECK(test::tells(complaintOfScenario(kLabelsStart + label +
                                        "box = [[0, 0, 0], [1, 1, 1]]\nframe = \"mars\"\n"),
                    "use \"world\" or \"organ\""));
  CHECK(test::tells(complaintOfScenario(kLabelsStart + "[organ.landmark]\nx = [0, 1]\n"),
                    "three finite numbers"));
  CHECK(test::tells(complaintOfScenario(kLabelsStart + label + "depth = [0, 1]\nname = \"a\"\n" +
                                        label + "depth = [0, 1]\nname = \"b\"\n"),
                    "a label has one name"));
  CHECK(test::tells(
      complaintOfScenario(kLabelsStart +
                          "[[tissue.material]]\nlabel = 1\n[[tissue.material]]\nlabel = 1\n"),
      "keep one of the two"));
  CHECK(test::tells(complaintOfScenario(kLabelsStart + "[[tissue.material]]\nyoung = 1000\n"),
                    "label is missing"));
}

TEST_CASE("a label that marks nothing and a material that nothing has are one clear sentence") {
  CHECK(complaintOfSetup(kLabelsStart + kLabels + kMaterials) == "");
  CHECK(test::tells(complaintOfSetup(kLabelsStart + "[[organ.label]]\nlabel = 4\nname = \"cyst\"\n"
                                                    "box = [[5, 5, 5], [6, 6, 6]]\n"),
                    "label 4 (cyst) marks no particle of the organ"));
  CHECK(test::tells(
      complaintOfSetup(kLabelsStart + "[[organ.label]]\nlabel = 4\nat = \"x\"\nradius = 0.1\n"),
      "the organ has no landmark \"x\""));
  for (const char* model : {"still", "elastic"})
    CHECK(test::tells(
        complaintOfSetup(kLabelsStart + kLabels + "[tissue]\nmodel = \"" + model +
                         "\"\n[[tissue.material]]\nlabel = 8\n"),
        "there is a material for label 8, which no particle of the organ has; labels are 7 "
        "(tumour), 9 (label 9)"));
  CHECK(test::tells(complaintOfSetup(kLabelsStart + "[[tissue.material]]\nlabel = 8\n"),
                    "mark cells by [[organ.label]]"));
  CHECK(test::tells(complaintOfSetup(kLabelsStart + kMaterials.substr(0, kMaterials.find("[[")) +
                                     "[[tissue.attachment]]\nbox = [[5, 5, 5], [6, 6, 6]]\n"),
                    "attachment 1 of the tissue holds no particle"));
}

TEST_CASE("cells of a label weigh what its material does, and attachments take organ regions") {
  const Scenario s = parseScenario(
      kLabelsStart + kLabels + kMaterials + "[[tissue.attachment]]\ndepth = [0, 0.01]\n", "x.toml");
  const Organ organ = makeOrgan(loadCells(s.organs[0].source, {}), s.organs[0].source.settings);
  CHECK(labelledParticles(organ.rest)[7] > 50);
  CHECK(labelledParticles(organ.rest)[9] > 50);
  const auto tissue = makeTissue(s.organs[0].tissue, organ);
  const auto& elastic = dynamic_cast<const ElasticTissue&>(*tissue);
  int held = 0, free = 0;
  for (std::int64_t c = 0; c < organ.rest.lattice.cellCount(); ++c) {
    if (!organ.rest.inside[std::size_t(c)]) continue;
    const ElasticState& state = elastic.state();
    const auto i = std::size_t(state.box.fromLattice(c));
    const double volume = organ.rest.lattice.cellVolume() * double(state.share[i]);
    const double density = double(state.weight[i]) * elastic.mass(c) / volume;
    CHECK(density == doctest::Approx(organ.rest.labelOf(c) == 7 ? 1500 : 1000));
    ++(state.held[i] ? held : free);
  }
  CHECK(held > 300);
  CHECK(free > 300);
}

TEST_CASE("a run's summary tells what became of each label") {
  Scenario s = parseScenario(
      kLabelsStart + kLabels +
          "[tissue]\ndensity = 1000\n[[tissue.material]]\nlabel = 9\ndensity = 1500\n",
      "x.toml");
  Simulation simulation = makeSimulation(s, {});
  const std::vector<LabelLedger> before = runScenario(simulation, s).ledger.organs[0].labels;
  REQUIRE(before.size() == 3);
  double volume = 0, mass = 0;
  std::int64_t particles = 0;
  for (const LabelLedger& label : before) {
    particles += label.tissue.before.particles;
    volume += label.tissue.before.volume;
    mass += label.tissue.before.mass;
    CHECK(label.tissue.removed == TissueAmount{});
    CHECK(label.tissue.left() == label.tissue.before);
  }
  CHECK(particles == simulation.organ().particles);
  CHECK(volume == doctest::Approx(simulation.organ().volume()));
  CHECK(before[1].name == "tumour");
  CHECK(before[2].label == 9);
  CHECK(before[2].tissue.before.mass == doctest::Approx(1500 * before[2].tissue.before.volume));
  CHECK(mass == doctest::Approx(1000 * volume + 500 * before[2].tissue.before.volume));

  // All of label 9 is taken out.
  FrameInput input = frameInput(s, 0);
  const Discretization& rest = simulation.organ().rest;
  for (std::int64_t c = 0; c < rest.lattice.cellCount(); ++c)
    if (rest.inside[std::size_t(c)] && rest.labelOf(c) == 9)
      input.edits.push_back({0, -1, RemoveCell{c}});
  simulation.step(input);
  const Ledger ledger = LedgerBooks(s, simulation).ledgerOf(simulation);
  CHECK(discrepancy(ledger, &simulation) == "");
  const std::vector<LabelLedger>& labels = ledger.organs[0].labels;
  CHECK(labels[2].tissue.removed.particles == labels[2].tissue.before.particles);
  CHECK(labels[2].tissue.left().particles == 0);
  CHECK(labels[1].tissue.removed.particles == 0);
  CHECK(labels[2].tissue.removed.volume == doctest::Approx(simulation.organ().removedVolume));
}

TEST_CASE("labels and landmarks of a file of cells are those of the organ that is read from it") {
  Scenario s = parseScenario(kLabelsStart + kLabels, "x.toml");
  const test::TemporaryFolder folder;
  const auto path = folder / "organ.resect-cells";
  writeParticleFile(path, {loadCells(s.organs[0].source, {}), {"test", "liver", 1}});
  const std::string source = "[organ]\nsource = \"" + path.string() + "\"\n";
  const std::string start = "title = \"t\"\nduration = 0.1\n" + source;
  Scenario other = parseScenario(
      start + "[[organ.label]]\nlabel = 7\nat = \"fundus\"\nradius = 0.04\n", "y.toml");
  const Discretization cells = loadCells(other.organs[0].source, {});
  CHECK(cells.labelName(7) == "tumour");
  CHECK(labelledParticles(cells)[9] == labelledParticles(loadCells(s.organs[0].source, {}))[9]);
  CHECK(labelledParticles(cells)[7] > labelledParticles(loadCells(s.organs[0].source, {}))[7]);
  other.organs[0].source.labels.clear();
  other.organs[0].source.resample = true;
  other.organs[0].source.spacing = 0.008;
  const Discretization finer = loadCells(other.organs[0].source, {});
  const double ratio = double(labelledParticles(finer)[7]) /
                       double(labelledParticles(loadCells(s.organs[0].source, {}))[7]);
  CHECK(ratio == doctest::Approx(1.25 * 1.25 * 1.25).epsilon(0.1));
  other.organs[0].source.unit = 0.001;
  CHECK_THROWS_AS(loadCells(other.organs[0].source, {}), Error);
}

TEST_CASE("stiffening and relaxation are read, come from liver, or are left out") {
  const auto tissueOf = [&](const std::string& keys) {
    return parseScenario(kLabelsStart + "[tissue]\nmodel = \"elastic\"\n" + keys, "x.toml")
        .organs[0]
        .tissue;
  };
  CHECK(tissueOf("").material.branches == liverTissue().branches);
  CHECK(tissueOf("").material.stiffening == liverTissue().stiffening);
  CHECK(tissueOf("plain = true").material.branches.empty());
  CHECK(tissueOf("plain = true").material.stiffening == 0);
  CHECK(tissueOf("plain = true\nstiffening = 3").material.stiffening == 3);
  CHECK(tissueOf("relaxation_shares = []").material.branches.empty());
  const TissueSetup given = tissueOf(
      "relaxation_shares = [0.5]\nrelaxation_times = [2]\n[[tissue.material]]\nlabel = 7\n"
      "relaxation_shares = [1, 2, 3]\nrelaxation_times = [1, 0.1, 0.01]\n");
  CHECK(given.material.branches == std::vector<Relaxation>{{0.5, 2}});
  CHECK(given.materialOf(7).branches == std::vector<Relaxation>{{1, 1}, {2, 0.1}, {3, 0.01}});
  for (const char* wrong :
       {"relaxation_shares = [0.5]", "relaxation_times = [1]", "stiffening = -1",
        "relaxation_shares = [1, 1, 1, 1]\nrelaxation_times = [1, 1, 1, 1]",
        "relaxation_shares = [1]\nrelaxation_times = [0.001]", "plain = 1"}) {
    CAPTURE(wrong);
    const std::string text =
        kLabelsStart + "[tissue]\nmodel = \"elastic\"\n" + std::string(wrong) + "\n";
    CHECK(test::isOneSentence(complaintOfScenario(text)));
  }
}
