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

// Reads and checks a scenario; Errors have file and line. Files named in it are searched beside it,
// then among the shipped ones.
Scenario readScenario(const std::filesystem::path& path);
Scenario parseScenario(const std::string& text, const std::string& name);

// Reads a tool's description and, with `readMesh`, the model beside it.
ToolModel readTool(const std::filesystem::path& path, const MeshReader& readMesh);

}  // namespace resect
