// Which options say what organ to take? The same on every command that takes one.
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

  // Overwrites what the person gave; leaves the rest of `source` as it is.
  void applyTo(OrganSource& source) const;
  // The same for a scenario's first organ, which becomes `organ` when that is named; with cells of
  // another size the other organs' change in proportion.
  void applyTo(Scenario& scenario, const std::string& organ) const;
};

// Reads models of all formats that Resect knows.
ModelReader modelReader();

// Adds --part, --unit, --repair, --spacing and --dims to a command.
std::shared_ptr<OrganOptions> addOrganOptions(CLI::App& command);

}  // namespace resect
