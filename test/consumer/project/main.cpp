#include <resect/io/data_folder.h>
#include <resect/io/operation_setup.h>
#include <resect/io/plain_mesh.h>
#include <resect/io/scenario/scenario_file.h>
#include <resect/version.h>

#include <algorithm>
#include <cstdio>

int main() try {
  auto scenario = resect::readScenario(resect::findDataFile("press", "scenarios", ".toml"));
  resect::Simulation simulation = resect::makeSimulation(scenario, resect::readPlainMesh);
  resect::StepReport report;
  double most = 0;
  for (std::int64_t frame = 0; frame < resect::frameCount(scenario); ++frame) {
    simulation.step(resect::frameInput(scenario, frame), report);
    most = std::max(most, report.toolForce[2].norm());
  }
  std::printf("Resect %s: %lld particles, at most %.1f N on the %s, state %016llx\n",
              RESECT_VERSION, (long long)simulation.organ().particles, most,
              scenario.tools[2].model.c_str(), (unsigned long long)simulation.stateHash());
} catch (const std::exception& e) {
  std::fprintf(stderr, "%s\n", e.what());
  return 1;
}
