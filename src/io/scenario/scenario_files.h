// Lists the files that a run of a scenario reads.
#pragma once

#include <filesystem>
#include <vector>

#include "operation/scenario.h"

namespace resect {

// Returns the scenario's own file, the files of its organs, the descriptions of its instruments and
// their models, and every file that comes with Resect (data_folder.h). A run must not write to any
// of these (io/output/run_files.h). To find the models, reads the descriptions. If a description is
// wrong, throws the same Error as loadTools(). A model file may refer to further files. Such
// further files are not in the list; layers that know the model's format add them.
std::vector<std::filesystem::path> filesRead(const Scenario& scenario);

// Throws Error if the source is neither a built-in organ nor an existing file. The Error names the
// built-in organs.
void requireOrganThere(const OrganSource& source);

// Every file that comes with Resect.
std::vector<std::filesystem::path> shippedFiles();

}  // namespace resect
