// The kinds of instrument and of working part, and how an instrument is made.
#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "tools/tool.h"

namespace resect {

struct PartKind {
  std::string_view name;
  std::unique_ptr<WorkingPart> (*make)();
};
// The list of working parts; a new one is one more line.
std::span<const PartKind> partKinds();

struct ToolKind {
  std::string_view name;
  std::vector<std::string_view> parts;
};
// All kinds of instrument, in the order in which they are shown to people.
std::span<const ToolKind> toolKinds();

// Makes the tool with the parts that model.parts names, or else those of model.kind; for an unknown
// name an Error lists the known ones. A tool whose response is "remove" has a Remover instead of
// all of them.
std::unique_ptr<Tool> makeTool(ToolModel model);

}  // namespace resect
