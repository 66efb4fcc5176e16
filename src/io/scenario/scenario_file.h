// Reads scenario files (TOML) and tools' description files. docs/scenarios.md lists the keys.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "operation/scenario.h"
#include "tools/tool.h"

namespace resect {

// Function that reads a model file as one closed, outward mesh in metres, or throws Error. Supplied
// by the caller, since the layer that reads Inventor files lies above this one.
using MeshReader = std::function<TriangleMesh(const std::filesystem::path&)>;

// Reads and checks a scenario; Errors name file and line. A file that the scenario names is looked
// for beside it; if it is not there, its name is kept as given (loadTools() in io/operation_setup.h
// then also looks among the shipped tools).
Scenario readScenario(const std::filesystem::path& path);
// The same from text; `name` stands for the file in Errors, and names of files are kept as given.
Scenario parseScenario(const std::string& text, const std::string& name);

// Reads a tool's description and, with `readMesh`, the model beside it.
ToolModel readTool(const std::filesystem::path& path, const MeshReader& readMesh);
// The same from text; `name` stands for the file in Errors.
ToolModel parseTool(const std::string& text, const std::string& name, const MeshReader& readMesh);

}  // namespace resect
