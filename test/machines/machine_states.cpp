// machine_states FRAMES SCENARIO...: plays the first frames of scenarios and prints, a line each,
// the name, the state hash and the seconds that it took. The hash must be the same on every
// machine.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>

#include "io/data_folder.h"
#include "io/operation_setup.h"
#include "io/plain_mesh.h"
#include "io/scenario/scenario_file.h"

int main(int count, char** arguments) try {
  for (int i = 2; i < count; ++i) {
    const auto start = std::chrono::steady_clock::now();
    auto scenario = resect::readScenario(resect::findDataFile(arguments[i], "scenarios", ".toml"));
    resect::Simulation simulation = resect::makeSimulation(scenario, resect::readPlainMesh);
    resect::StepReport report;
    const std::int64_t frames =
        std::min<std::int64_t>(std::atoi(arguments[1]), resect::frameCount(scenario));
    for (std::int64_t frame = 0; frame < frames; ++frame)
      simulation.step(resect::frameInput(scenario, frame), report);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    std::printf("%s %016llx %.2f\n", arguments[i], (unsigned long long)simulation.stateHash(),
                taken.count());
  }
} catch (const std::exception& e) {
  std::fprintf(stderr, "%s\n", e.what());
  return 1;
}
