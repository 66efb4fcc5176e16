// A recorded operation as a series of .vtp files with a .pvd, for ParaView.
#pragma once

#include <filesystem>

#include "io/output/run_files.h"
#include "record/export/moments.h"

namespace resect {

// What `name`, as folder/series.vtp, stands for: folder/series_0001.vtp and so on, and
// folder/series.pvd.
struct VtpSeries {
  NumberedOutputs files;
  std::filesystem::path list;
};
VtpSeries seriesOf(const std::filesystem::path& name, const std::string& option);

// Writes the surfaces of all organs, a file for each moment, then the list. Times are those of the
// operation. Files of an earlier run must be gone (removeNumberedFiles()). Returns their number.
std::int64_t exportVtp(Replay& replay, const ExportedPart& part, const VtpSeries& series,
                       const Progress& progress = {});

}  // namespace resect
