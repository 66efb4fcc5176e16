// All that an operation starts from, as a value that needs no file: what a recording holds so that
// it can be played anywhere.
#pragma once

#include <span>
#include <vector>

#include "operation/scenario.h"
#include "sph/discretization.h"

namespace resect {

struct RecordedSetup {
  Scenario scenario;
  std::vector<Discretization> cells;  // one per organ, placed and labelled
  std::vector<ToolModel> tools;       // one per tool, with their meshes
};

// The name of a tool as people see it everywhere; empty if there is no tool of that number.
inline std::string toolName(const RecordedSetup& setup, std::int64_t tool) {
  const bool there = tool >= 0 && std::size_t(tool) < setup.tools.size();
  return there ? setup.tools[std::size_t(tool)].name : std::string();
}

// The setup of a simulation that was made from `scenario` and has not been changed from outside.
RecordedSetup setupOf(const Scenario& scenario, const Simulation& simulation);

// The operation at its start: the same inputs give the same bits as in the simulation that the
// setup was taken from. Throws Error if the setup cannot be run.
Simulation simulationOf(const RecordedSetup& setup);

// The setup as bytes: the scenario and the tools as a saved state (base/state/saved_state.h), the
// cells as a file of cells each (docs/cells_file.md).
struct SetupBytes {
  Bytes scenario;
  std::vector<std::string> cells;
};
SetupBytes toBytes(const RecordedSetup& setup);
// Throws Error if anything is damaged or out of range.
RecordedSetup setupFromBytes(const SetupBytes& bytes);

}  // namespace resect
