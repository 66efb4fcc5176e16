#include "cli/organ_options.h"

#include <algorithm>
#include <charconv>
#include <filesystem>

#include "anatomy/structure_kind.h"
#include "base/error.h"
#include "base/text/file_stem.h"
#include "cli/progress_bar.h"
#include "cli/shared_options.h"
#include "formats/labels/brought_organ.h"
#include "formats/labels/label_model.h"
#include "inventor/reading/model_file.h"
#include "io/cells/particle_file.h"
#include "io/scenario/length.h"
#include "io/scenario/orientation.h"
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

// Adds what --structure names: a kind, and a file, or a part of the organ's own file.
void addGiven(OrganSource& source, const std::string& given) {
  const std::size_t sign = given.find('=');
  const std::string word = given.substr(0, sign);
  const auto kind = structureKind(word);
  if (sign == std::string::npos || sign + 1 == given.size() || !kind ||
      *kind == StructureKind::Parenchyma)
    throw usageError(
        "--structure is \"{}\"; give a kind of structure and its file or its part of the organ's "
        "file, such as tumour=tumour.stl or portal-vein=7; kinds are {}",
        given, structureWords());
  const std::string what = given.substr(sign + 1);
  const bool isNumber = std::ranges::all_of(what, [](char c) { return c >= '0' && c <= '9'; });
  std::string file = std::filesystem::exists(what) ? what : "";
  if (std::filesystem::is_directory(source.file))  // of files, each with a structure
    for (const auto& entry : std::filesystem::directory_iterator(source.file))
      if (fileStem(entry.path().string()) == what) file = entry.path().string();
  if (!file.empty())
    addStructure(source, *kind, fileStem(file), file, "");
  else
    addStructure(source, *kind, isNumber ? word : what, "", what);
}

}  // namespace

void OrganOptions::applyTo(OrganSource& source) const {
  requireOrganThere(source);
  if (!part.empty()) source.part = part;
  if (!unit.empty()) source.unit = parseUnit(unit, "--unit");
  source.repair = source.repair || repair;
  for (const std::string& one : structures) addGiven(source, one);
  if (!isBuiltIn(source) && isLabelled(source.file)) {  // a folder may have the name too
    if (!unit.empty())
      throw usageError("{}: label images tell their size themselves; leave --unit out",
                       source.file);
    if (!orientation.empty())
      throw usageError("{}: label images tell their directions themselves; leave --orientation out",
                       source.file);
    takeLabels(source);
  }
  if (!orientation.empty() || !rotate.empty()) {
    if (isParticleFile(source.file))
      throw usageError("{} holds particles, which are not turned; leave {} out", source.file,
                       rotate.empty() ? "--orientation" : "--rotate");
    if (!orientation.empty()) source.pose.rotation = orientationOf(orientation);
    if (!rotate.empty())
      source.pose.rotation = (turnOf(rotate) * source.pose.rotation).normalized();
  }
  if (spacing == "auto") {  // chosen when the organ is made
    source.spacing.reset();
    source.dims.reset();
    source.resample = true;
  } else if (!spacing.empty()) {
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
  if (!organ.empty()) {
    if (first.file != organ) scenario.description.clear();  // it is of the scenario's own organ
    first.file = organ;
    first.finerIfSmall = scenario.mode != OperationMode::Thesis && spacing.empty();
    first.structures.clear();    // they lie in the organ that is replaced
    scenario.closeUp.reset();    // of the scenario's own organ
    scenario.setting = "table";  // the field was made for a liver; --setting shows it all the same
  }
  for (const ScenarioOrgan& one : scenario.organs) requireOrganThere(one.source);
  applyTo(first);
  if (before && first.spacing) setSpacing(scenario, *before, *first.spacing);
}

ModelReader modelReader() {
  return [](const std::filesystem::path& path, const std::string& parts) {
    return readModelWatched(path, progressBar("reading"), parts);
  };
}

std::shared_ptr<OrganOptions> addOrganOptions(Command command) {
  auto options = std::make_shared<OrganOptions>();
  addPartOption(command, options->part);
  command
      .option("--structure", options->structures,
              "What lies in the organ: KIND=FILE, or KIND=PART of the organ's own file, such as "
              "tumour=lesion.stl; may be given several times")
      .oneValueEach();
  command.option("--unit", options->unit,
                 "What the model's numbers are: mm, cm, m, um, in, or metres per unit");
  command.flag("--repair", options->repair,
               "Close the holes of an open mesh instead of refusing it");
  command.option("--orientation", options->orientation,
                 "Where the model's x, y, z axis point to in the patient, as LPS or RAS");
  command.option("--rotate", options->rotate,
                 "Degrees about the room's X (to the patient's left), Y (up), Z (to the surgeon): "
                 "0,90,0");
  const Option spacing = command.option(
      "--spacing", options->spacing,
      "Side of the cubic cells, as 5mm; auto: the largest that keep 98 % of the tissue");
  command
      .option("--dims", options->dims,
              "Samples over the bounding box, as the thesis has them: 20 or 20,20,20")
      .excludes(spacing);
  return options;
}

}  // namespace resect
