#include "io/scenario/scenario_files.h"

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
  for (const ScenarioOrgan& organ : scenario.organs)
    if (!isBuiltIn(organ.source)) files.emplace_back(organ.source.file);
  for (const ScenarioTool& tool : scenario.tools) {
    files.push_back(findDataFile(tool.model, "tools", ".toml"));
    // The mesh is not needed here.
    const ToolModel model = readTool(files.back(), [](const auto&) { return TriangleMesh(); });
    files.push_back(model.file);
    files.push_back(std::filesystem::path(model.file).replace_extension(".ply"));  // readPlainMesh
  }
  return files;
}

}  // namespace resect
