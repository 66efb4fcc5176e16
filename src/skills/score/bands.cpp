#include "skills/score/bands.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "io/data_folder.h"
#include "operation/task/measure.h"

namespace resect {

PublishedStudy readPublishedStudy(const std::string& name) {
  const auto known = shippedNames("bands", ".toml");
  if (std::ranges::count(known, name) == 0)
    throw error("there is no published band \"{}\"; those that come with Resect are: {}", name,
                fmt::join(known, ", "));
  const TomlTable t = TomlTable::readFile(dataFolder() / "bands" / (name + ".toml"));
  PublishedStudy study{name, t.text("study"), t.text("source"), t.text("about"), {}};
  for (const TomlTable& one : t.tables("band")) {
    PublishedBand band;
    band.measure = one.text("measure");
    if (!findMeasure(band.measure))
      one.complain("measure", "is \"" + band.measure + "\"; the measures are: " + measureNames());
    for (const TomlTable& group : one.tables("groups")) {
      band.groups.push_back(
          {group.text("name"), group.number("mean", -1e9, 1e9), group.number("deviation", 0, 1e9)});
      group.refuseUnknownKeys();
    }
    one.refuseUnknownKeys();
    study.bands.push_back(std::move(band));
  }
  t.refuseUnknownKeys();
  return study;
}

std::vector<TaskBand> bandsOf(std::span<const std::vector<Measured>> runs) {
  std::vector<TaskBand> bands;
  if (runs.size() < kLeastBandRuns) return bands;
  for (const char* measure :
       {"time_s", "path_length_m", "movements", "force_p95_n", "blood_loss_ml"}) {
    double sum = 0, squares = 0;
    std::size_t count = 0;
    for (const std::vector<Measured>& run : runs)
      if (const auto value = valueOf(run, measure)) sum += *value, ++count;
    if (count < runs.size()) continue;
    const double mean = sum / double(count);
    for (const std::vector<Measured>& run : runs)
      squares += std::pow(*valueOf(run, measure) - mean, 2);
    const double deviation = std::sqrt(squares / double(count - 1));
    if (deviation > 0) bands.push_back({measure, mean, deviation});
  }
  return bands;
}

}  // namespace resect
