// The liver's thin margin, once it lies on the table.
#include <doctest/doctest.h>

#include <algorithm>

#include "io/operation_setup.h"
#include "io/scenario/scenario_file.h"

using namespace resect;

namespace {

// How much longer or shorter all but one in a thousand of the triangles' sides have become at most,
// as a share.
double sideStrain(const std::string& organ) {
  Scenario scenario =
      parseScenario("title = \"Margin\"\nduration = 1.5\nframe_rate = 60\n[organ]\n" + organ +
                        "[tissue]\nmodel = \"elastic\"\n",
                    "test.toml");
  Simulation simulation = makeSimulation(scenario, {});
  for (int frame = 0; frame < 90; ++frame) simulation.step(frameInput(scenario, frame));
  const OperatedOrgan& operated = simulation.organs()[0];
  const std::span<const Vec3f> rest = operated.organ.surface.points(), now = operated.skin.points();
  std::vector<float> strains;
  for (const Triangle& t : operated.organ.surface.triangles())
    for (std::size_t k = 0; k < 3; ++k) {
      const auto a = std::size_t(t[k]), b = std::size_t(t[(k + 1) % 3]);
      const float before = (rest[a] - rest[b]).norm();
      if (before < 1e-4f) continue;  // slivers tell nothing
      strains.push_back(std::abs((now[a] - now[b]).norm() / before - 1));
    }
  std::ranges::sort(strains);
  return strains[strains.size() - strains.size() / 1000];
}

}  // namespace

TEST_CASE("vertices side by side on the liver's margin move alike") {
  // As it lies, turned in the lattice, and finer.
  for (const char* organ : {"spacing = \"8mm\"\nposition = [-0.073, 0, 0.002]\n",
                            "spacing = \"8mm\"\nposition = [-0.07, 0, 0]\nrotation = { axis = [0, "
                            "1, 0], degrees = 33 }\n",
                            "spacing = \"6mm\"\nposition = [-0.07, 0, 0]\n"}) {
    const double strain = sideStrain(organ);
    MESSAGE(std::string(organ), 100 * strain, " %");
    CHECK(strain < 0.8);
  }
}
