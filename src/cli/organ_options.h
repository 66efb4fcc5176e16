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

  // Overwrites those settings of `source` for which an option was given.
  void applyTo(OrganSource& source) const;
  // The same for a scenario's first organ. `organ`, if not empty, replaces its file. A new spacing
  // scales the spacings of the other organs in proportion.
  void applyTo(Scenario& scenario, const std::string& organ) const;
};

// A reader of models in all formats that Resect knows; it shows a progress bar.
ModelReader modelReader();

// Adds --part, --unit, --repair, --spacing and --dims to a command.
std::shared_ptr<OrganOptions> addOrganOptions(CLI::App& command);

}  // namespace resect
