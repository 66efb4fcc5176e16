// Command-line options that choose an organ, the same for every command.
#pragma once

#include <memory>
#include <string>

#include "io/operation_setup.h"
#include "operation/scenario.h"

namespace CLI {
class App;
}

namespace resect {

struct OrganOptions {
  std::string part, unit, spacing, dims;
  bool repair = false;

  // Overwrites the given options in `source`; leaves the rest.
  void applyTo(OrganSource& source) const;
  // The same for a scenario's first organ, which is replaced by `organ` if not empty; a new spacing
  // scales the other organs' in proportion.
  void applyTo(Scenario& scenario, const std::string& organ) const;
};

// Reads models of all formats that Resect knows.
ModelReader modelReader();

// Adds --part, --unit, --repair, --spacing and --dims to a command.
std::shared_ptr<OrganOptions> addOrganOptions(CLI::App& command);

}  // namespace resect
