// Exports a recorded operation as a series of .vtp files and a .pvd file, for ParaView.
#pragma once

#include <filesystem>

#include "io/output/run_files.h"
#include "record/export/moments.h"

namespace resect {

// The files of a series: one .vtp file per moment, and a .pvd file that lists them. The name
// folder/series.vtp stands for folder/series_0001.vtp, folder/series_0002.vtp and so on, and for
// folder/series.pvd.
struct VtpSeries {
  NumberedOutputs files;
  std::filesystem::path list;
};
// option: the command-line option by which the user gave `name`, for messages.
VtpSeries seriesOf(const std::filesystem::path& name, const std::string& option);

// Writes one .vtp file for each moment, with the surfaces of all organs, and then the .pvd file.
// The times in the files are simulated times of the operation. The caller must have removed files
// of an earlier run (removeNumberedFiles()). Returns the number of .vtp files.
std::int64_t exportVtp(Replay& replay, const ExportedPart& part, const VtpSeries& series,
                       const Progress& progress = {});

}  // namespace resect
