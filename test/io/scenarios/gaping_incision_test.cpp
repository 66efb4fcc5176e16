// The scenario `incise`: a long cut over the dome of a liver that lies still.
#include <doctest/doctest.h>

#include <algorithm>

#include "io/data_folder.h"
#include "io/operation_setup.h"
#include "io/plain_mesh.h"
#include "io/scenario/scenario_file.h"
#include "support/figures.h"
#include "tissue/elastic/elastic_tissue.h"

using namespace resect;

namespace {

// How far cells that were neighbours across the cut, at the surface, have moved apart at the end:
// the median, m. The cut runs along z.
double gape(double spacing, double tension) {
  Scenario scenario = readScenario(findDataFile("incise", "scenarios", ".toml"));
  scenario.organs[0].source.spacing = spacing;
  scenario.organs[0].tissue.material.capsuleTension = tension;
  scenario.organs[0].source.vessels.clear();
  Simulation simulation = makeSimulation(scenario, readPlainMesh);
  StepReport report;
  for (int frame = 0; frame < frameCount(scenario); ++frame)
    simulation.step(frameInput(scenario, frame), report);
  const auto& tissue = dynamic_cast<const ElasticTissue&>(*simulation.organs()[0].tissue);
  const ElasticState& state = tissue.state();
  int alongX = 0;
  while (offsetOf(alongX) != Vec3i(1, 0, 0)) ++alongX;
  std::vector<double> apart;
  for (std::int32_t i = 0; i < state.box.size; ++i) {
    const std::int32_t j = i + 1;
    if (state.skinArea[i] > 0 && state.skinArea[j] > 0 && state.solid[i] && state.solid[j] &&
        !(state.bonds[i] >> alongX & 1))
      apart.push_back(double(state.u[0][j]) - double(state.u[0][i]));
  }
  REQUIRE(apart.size() > 5);
  std::ranges::nth_element(apart, apart.begin() + std::ptrdiff_t(apart.size() / 2));
  return apart[apart.size() / 2];
}

}  // namespace

TEST_CASE("an incision in a still liver gapes because its capsule is under tension") {
  test::Figures figures("gaping incision");
  const double coarse = gape(0.008, 30), fine = gape(0.005, 30), slack = gape(0.008, 0);
  MESSAGE("cells of 8 mm: " << 1e3 * coarse << " mm; of 5 mm: " << 1e3 * fine
                            << " mm; without tension: " << 1e3 * slack << " mm");
  CHECK(coarse > 0.0003);
  CHECK(coarse < 0.002);
  CHECK(slack < 0.4 * coarse);
  CHECK(figures.add("gape, cells of 8 mm against 5 mm", coarse, fine, 0.3) < 0.3);
}
