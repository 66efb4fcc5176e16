// Published bands: what experts and novices reached in a study. Each is a data file with its source
// (data/bands/*.toml); none is invented, and a measure without one is shown without one.
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
  std::string name;    // of the file
  std::string study;   // "Lefor 2022"
  std::string source;  // DOI or address
  std::string about;   // the task of the study, and how far it can be compared
  std::vector<PublishedBand> bands;
};

// Throws Error if data/bands has no such file, naming those that there are, or if a value is wrong.
PublishedStudy readPublishedStudy(const std::string& name);

// A task's own bands, of runs that a teacher has marked as reference: mean and standard deviation
// (of a sample) of time, path length, movements, force and blood. A measure that a run lacks, or
// that is the same in all of them, has none.
inline constexpr std::size_t kLeastBandRuns = 3;
std::vector<TaskBand> bandsOf(std::span<const std::vector<Measured>> runs);

}  // namespace resect
