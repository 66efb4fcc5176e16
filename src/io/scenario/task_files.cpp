#include "io/scenario/task_files.h"

#include "io/data_folder.h"

namespace resect {

std::filesystem::path findScenario(const std::string& name) {
  std::error_code ec;
  const std::filesystem::path task = dataFolder() / "tasks" / (name + ".toml");
  if (!std::filesystem::exists(name, ec) && std::filesystem::is_regular_file(task, ec)) return task;
  return findDataFile(name, "scenarios", ".toml");
}

}  // namespace resect
