#include "cli/organ_options.h"

#include <charconv>

#include "base/error.h"
#include "cli/progress_bar.h"
#include "cli/shared_options.h"
#include "inventor/reading/model_file.h"
#include "io/scenario/length.h"
#include "io/scenario/scenario_files.h"
#include "operation/setting_ranges.h"

namespace resect {
namespace {

// "20" or "20,30,40".
Vec3i parseDims(const std::string& text) {
  Vec3i dims;
  int count = 0;
  const char* at = text.data();
  const char* end = at + text.size();
  while (count < 3) {
    const auto [rest, ec] = std::from_chars(at, end, dims[count]);
    if (ec != std::errc() || dims[count] < 1 || dims[count] > 2000) break;
    ++count;
    at = rest;
    if (at == end || *at != ',') break;
    ++at;
  }
  if (at != end || (count != 1 && count != 3))
    throw usageError("--dims is \"{}\"; give one number or three from 1 to 2000, as 20 or 20,20,20",
                     text);
  return count == 1 ? Vec3i(Vec3i::Constant(dims[0])) : dims;
}

}  // namespace

void OrganOptions::applyTo(OrganSource& source) const {
  requireOrganThere(source);
  if (!part.empty()) source.part = part;
  if (!unit.empty()) source.unit = parseUnit(unit, "--unit");
  source.repair = source.repair || repair;
  if (!spacing.empty()) {
    const double s = parseLength(spacing, "--spacing");
    if (!ranges::kSpacing.holds(s))
      throw usageError("--spacing is {}; give a length from {} to {}", spacing,
                       lengthText(ranges::kSpacing.low), lengthText(ranges::kSpacing.high));
    source.spacing = s;
    source.dims.reset();
    source.resample = true;
  }
  if (!dims.empty()) {
    source.dims = parseDims(dims);
    source.spacing.reset();
    source.resample = true;
  }
}

void OrganOptions::applyTo(Scenario& scenario, const std::string& organ) const {
  OrganSource& first = scenario.organs[0].source;
  const std::optional<double> before = first.spacing;
  if (!organ.empty()) first.file = organ;
  for (const ScenarioOrgan& one : scenario.organs) requireOrganThere(one.source);
  applyTo(first);
  if (before && first.spacing) setSpacing(scenario, *before, *first.spacing);
}

ModelReader modelReader() {
  return [](const std::filesystem::path& path) {
    return readModelWatched(path, progressBar("reading"));
  };
}

std::shared_ptr<OrganOptions> addOrganOptions(Command command) {
  auto options = std::make_shared<OrganOptions>();
  addPartOption(command, options->part);
  command.option("--unit", options->unit,
                 "What the model's numbers are: mm, cm, m, um, in, or metres per unit");
  command.flag("--repair", options->repair,
               "Close the holes of an open mesh instead of refusing it");
  const Option spacing =
      command.option("--spacing", options->spacing, "Side of the cubic cells, as 5mm");
  command
      .option("--dims", options->dims,
              "Samples over the bounding box, as the thesis has them: 20 or 20,20,20")
      .excludes(spacing);
  return options;
}

}  // namespace resect
