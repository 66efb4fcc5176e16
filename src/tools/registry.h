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
// The kinds of working part. A new kind is one more line in this list.
std::span<const PartKind> partKinds();

struct ToolKind {
  std::string_view name;
  std::vector<std::string_view> parts;
};
// All kinds of instrument, in the order in which they are shown to people.
std::span<const ToolKind> toolKinds();

// Makes a tool with the working parts that model.parts names, or with those of model.kind if it
// names none. A tool whose response is "remove" has a Remover as its only part. Throws Error for an
// unknown name, with the list of the known ones.
std::unique_ptr<Tool> makeTool(ToolModel model);

}  // namespace resect
