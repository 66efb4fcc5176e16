// Which kinds of instrument and which working parts are there, and how is an instrument made?
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
// A new kind of part is one more line there.
std::span<const PartKind> partKinds();

struct ToolKind {
  std::string_view name;
  std::vector<std::string_view> parts;
};
// All kinds, in the order that people are shown.
std::span<const ToolKind> toolKinds();

// Makes the tool with the parts that model.parts names, or else those of model.kind; an Error lists
// what there is when there is none of that name. A tool whose response is "remove" has a Remover
// instead of all of them.
std::unique_ptr<Tool> makeTool(ToolModel model);

}  // namespace resect
