// Reads scenario files and the description files of tools. Both are TOML files. docs/scenarios.md
// and docs/how-to/add_a_tool.md list the keys.
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

// Reads and checks a scenario; Errors name file and line. A scenario names other files. If such a
// file lies in the scenario's folder, the result has the path to the file. Otherwise the result has
// the name as given. Instead of a tool's file, a scenario may give the name of a tool that comes
// with Resect; loadTools() (io/operation_setup.h) finds the file of this tool.
Scenario readScenario(const std::filesystem::path& path);
// Does the same with the text of a scenario. Errors use `name` as the file's name. The result has
// all names of files as given.
Scenario parseScenario(const std::string& text, const std::string& name);

// Reads a tool's description file, and calls `readMesh` to read the model file that the description
// names.
ToolModel readTool(const std::filesystem::path& path, const MeshReader& readMesh);
// Does the same with the text of such a file. Errors use `name` as the file's name.
ToolModel parseTool(const std::string& text, const std::string& name, const MeshReader& readMesh);

}  // namespace resect
