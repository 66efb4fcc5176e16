// The complete initial data of an operation, without references to files. A recording holds these
// data, so that the recording can be played on any machine.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "anatomy/anatomy.h"
#include "operation/scenario.h"
#include "simulation/surroundings.h"
#include "sph/discretization.h"

namespace resect {

struct RecordedSetup {
  Scenario scenario;
  std::vector<Discretization> cells;  // one per organ, at its final position and with labels
  std::vector<ToolModel> tools;       // one per tool, with its meshes
  std::vector<Anatomy> anatomies;     // one per organ, at its final position; may have no vessels
  // What stood round the organs. None: an older version of the program made the recording. In such
  // a version there were always the tool box and a table without an end.
  std::optional<Surroundings> surroundings = std::nullopt;
};

// The name of a tool, for people; empty if there is no tool with that number.
inline std::string toolName(const RecordedSetup& setup, std::int64_t tool) {
  const bool there = tool >= 0 && std::size_t(tool) < setup.tools.size();
  return there ? setup.tools[std::size_t(tool)].name : std::string();
}

// The setup of a simulation that was made from `scenario`. The simulation's organs and tools must
// still be those with which it was made. Throws Error if the simulation does not have as many
// organs and as many tools as the scenario.
RecordedSetup setupOf(const Scenario& scenario, const Simulation& simulation);

// Makes the simulation at the start of the operation. With equal inputs it computes the same bits
// as the simulation from which the setup was taken. Throws Error if the setup cannot be run.
Simulation simulationOf(const RecordedSetup& setup);

// The setup as bytes. `scenario` holds the scenario and the tools as a saved state
// (base/state/saved_state.h). `cells` holds one file of cells per organ (docs/cells_file.md).
struct SetupBytes {
  Bytes scenario;
  std::vector<std::string> cells;
};
SetupBytes toBytes(const RecordedSetup& setup);
// Throws Error if the bytes are damaged or a value is out of range.
RecordedSetup setupFromBytes(const SetupBytes& bytes);

}  // namespace resect
