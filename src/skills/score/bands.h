// Published bands: the results of experts and novices in a study. Each study is a data file that
// names its source (data/bands/*.toml). A measure without a published band is shown without a band.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/scenario/toml_table.h"
#include "operation/task/task.h"
#include "skills/score/measures.h"

namespace resect {

struct PublishedBand {
  struct Group {
    std::string name;  // "experts"
    double mean = 0, deviation = 0;
  };
  std::string measure;  // MeasureKind::id
  std::vector<Group> groups;
};

struct PublishedStudy {
  std::string name;    // name of the file, without .toml
  std::string study;   // "Lefor 2022"
  std::string source;  // DOI or address
  std::string about;   // the study's task; how far its results can be compared with an attempt
  std::vector<PublishedBand> bands;
};

// Reads the study data/bands/<name>.toml. Throws Error if there is no such file (the Error lists
// the files that exist), or if a value in the file is wrong.
PublishedStudy readPublishedStudy(const std::string& name);

// bandsOf() computes a task's own bands from runs that a teacher marked as reference. A band is the
// mean and the sample standard deviation of a measure. There can be bands for time, path length,
// movements, force and blood. If a run lacks a measure, or if all runs have the same value of it,
// the measure gets no band. With fewer than kLeastBandRuns runs there are no bands.
inline constexpr std::size_t kLeastBandRuns = 3;
std::vector<TaskBand> bandsOf(std::span<const std::vector<Measured>> runs);

}  // namespace resect
