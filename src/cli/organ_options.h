// Command-line options that choose an organ, the same for every command.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cli/command_line.h"
#include "io/operation_setup.h"
#include "operation/scenario.h"

namespace resect {

struct OrganOptions {
  // As the user wrote them; "": option not given.
  std::string part, unit, spacing, dims, orientation, rotate;
  std::vector<std::string> structures;  // the values of --structure
  bool repair = false;                  // whether --repair was given

  // Overwrites those settings of `source` for which an option was given.
  void applyTo(OrganSource& source) const;
  // Applies the options to the first organ of a scenario. `organ`, if not empty, replaces the file
  // of that organ. If its spacing changes, those of the other organs change in proportion.
  void applyTo(Scenario& scenario, const std::string& organ) const;
};

// Returns a function that reads models in all formats that Resect knows and shows a progress bar.
ModelReader modelReader();

// Adds --part, --structure, --unit, --repair, --orientation, --rotate, --spacing and --dims to a
// command.
std::shared_ptr<OrganOptions> addOrganOptions(Command command);

}  // namespace resect
