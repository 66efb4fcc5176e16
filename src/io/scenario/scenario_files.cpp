#include "io/scenario/scenario_files.h"

#include "base/error.h"
#include "io/data_folder.h"
#include "io/scenario/scenario_file.h"

namespace resect {

std::vector<std::filesystem::path> shippedFiles() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(dataFolder()))
    if (entry.is_regular_file()) files.push_back(entry.path());
  return files;
}

std::vector<std::filesystem::path> filesRead(const Scenario& scenario) {
  std::vector<std::filesystem::path> files = shippedFiles();
  if (!scenario.file.empty()) files.emplace_back(scenario.file);
  for (const ScenarioOrgan& organ : scenario.organs) {
    if (!isBuiltIn(organ.source)) files.emplace_back(organ.source.file);
    if (isVesselsFile(organ.source)) files.emplace_back(organ.source.vessels);
    for (const BroughtStructure& one : organ.source.structures) files.emplace_back(one.file);
  }
  for (const ScenarioTool& tool : scenario.tools) {
    files.push_back(findDataFile(tool.model, "tools", ".toml"));
    // The mesh is not needed here.
    const ToolModel model = readTool(files.back(), [](const auto&) { return TriangleMesh(); });
    files.push_back(model.file);
    files.push_back(std::filesystem::path(model.file).replace_extension(".ply"));  // readPlainMesh
  }
  return files;
}

void requireOrganThere(const OrganSource& source) {
  std::error_code ec;
  if (isBuiltIn(source) ||
      std::filesystem::status(source.file, ec).type() != std::filesystem::file_type::not_found)
    return;
  throw error("{}: there is no such file; check the name, or choose a built-in organ: {}",
              source.file, builtInOrgans());
}

}  // namespace resect
