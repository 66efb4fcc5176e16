// Reads scenario files and the description files of tools, both TOML. docs/scenarios.md and
// docs/how-to/add_a_tool.md list the keys.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "operation/scenario.h"
#include "tools/tool.h"

namespace resect {

// Function that reads a model file and returns one closed mesh, oriented outwards, in metres, or
// throws Error. The caller supplies it, since the layer that reads Inventor files lies above this
// one.
using MeshReader = std::function<TriangleMesh(const std::filesystem::path&)>;

// Reads and checks a scenario; Errors name file and line. If the scenario names a file that lies
// in the scenario's folder, the result has the path to that file. Otherwise the result has the name
// as given. A tool's file that does not lie in that folder may be one that comes with Resect, which
// loadTools() (io/operation_setup.h) finds.
Scenario readScenario(const std::filesystem::path& path);
// Does the same with the text of a scenario. `name` stands for the file in Errors. The result has
// the names of files as given.
Scenario parseScenario(const std::string& text, const std::string& name);

// Reads a tool's description file, and calls `readMesh` to read the model file that it names.
ToolModel readTool(const std::filesystem::path& path, const MeshReader& readMesh);
// The same from text; `name` stands for the file in Errors.
ToolModel parseTool(const std::string& text, const std::string& name, const MeshReader& readMesh);

}  // namespace resect
