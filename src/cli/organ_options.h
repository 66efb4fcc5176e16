// Command-line options that choose an organ. Several commands share these options.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cli/command_line.h"
#include "io/operation_setup.h"
#include "operation/scenario.h"

namespace resect {

struct OrganOptions {
  // The values of the options as the user wrote them; "": the option was not given.
  std::string part, unit, spacing, dims, orientation, rotate;
  std::vector<std::string> structures;  // the values of --structure
  bool repair = false;                  // whether --repair was given

  // Overwrites those settings of `source` for which an option was given.
  void applyTo(OrganSource& source) const;
  // Applies the options to the first organ of a scenario. If `organ` is not empty, it replaces the
  // file of the first organ. If the spacing of the first organ (the side of its cells) changes, the
  // spacings of the other organs change in proportion.
  void applyTo(Scenario& scenario, const std::string& organ) const;
};

// Returns a function that reads models in all formats that Resect knows and shows a progress bar.
ModelReader modelReader();

// Adds --part, --structure, --unit, --repair, --orientation, --rotate, --spacing and --dims to a
// command.
std::shared_ptr<OrganOptions> addOrganOptions(Command command);

}  // namespace resect
