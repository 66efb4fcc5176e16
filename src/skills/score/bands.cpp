#include "skills/score/bands.h"

#include "io/data_folder.h"
#include "operation/task/measure.h"

namespace resect {

PublishedStudy readPublishedStudy(const std::string& name) {
  const TomlTable t = TomlTable::readFile(findDataFile(name, "bands", ".toml"));
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

}  // namespace resect
