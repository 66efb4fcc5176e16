// Which kinds of instrument are there, and how is one made?
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "tools/tool.h"

namespace resect {

struct ToolKind {
  std::string_view name;
  std::unique_ptr<Tool> (*make)(ToolModel);
};

// All kinds, in the order that people are shown. A new instrument is one more line here.
std::span<const ToolKind> toolKinds();

// Makes the tool that model.kind names; an Error lists the kinds when there is none of that name.
std::unique_ptr<Tool> makeTool(ToolModel model);

}  // namespace resect
