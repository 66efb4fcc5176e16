// The files that a run of a scenario reads.
#pragma once

#include <filesystem>
#include <vector>

#include "operation/scenario.h"

namespace resect {

// The scenario's own file, organs, descriptions of instruments and their models, and all that comes
// with Resect (data_folder.h): no run may write to them (io/output/run_files.h). Reads the
// descriptions; throws Error as loadTools() does if one is wrong. What a model file names in turn
// is for the layers that know its format.
std::vector<std::filesystem::path> filesRead(const Scenario& scenario);

// Throws Error, with the names of the built-in organs, if the source is none of them and there is
// no file of its name.
void requireOrganThere(const OrganSource& source);

// Every file that comes with Resect.
std::vector<std::filesystem::path> shippedFiles();

}  // namespace resect
