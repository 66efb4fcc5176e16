// A recorded operation as a series of .vtp files with a .pvd, for ParaView.
#pragma once

#include <filesystem>

#include "io/output/run_files.h"
#include "record/export/moments.h"

namespace resect {

// The files of a series. The name folder/series.vtp stands for folder/series_0001.vtp,
// folder/series_0002.vtp and so on, and for folder/series.pvd, which lists them.
struct VtpSeries {
  NumberedOutputs files;
  std::filesystem::path list;
};
VtpSeries seriesOf(const std::filesystem::path& name, const std::string& option);

// Writes one .vtp file for each moment, with the surfaces of all organs, then the list. Times are
// those of the operation. Files of an earlier run must be gone (removeNumberedFiles()). Returns the
// number of .vtp files.
std::int64_t exportVtp(Replay& replay, const ExportedPart& part, const VtpSeries& series,
                       const Progress& progress = {});

}  // namespace resect
