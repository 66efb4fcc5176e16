// The kinds of instrument and of working part (a part of an instrument that acts on tissue), and
// how an instrument is made.
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
// The kinds of working part. To add a kind, add a line to the list in registry.cpp.
std::span<const PartKind> partKinds();

struct ToolKind {
  std::string_view name;
  std::vector<std::string_view> parts;
  bool stopsBleeding = false;  // useful only if an organ can bleed
};
// All kinds of instrument, in the order in which users see them.
std::span<const ToolKind> toolKinds();

// Makes a tool. If model.response is "remove", the tool's only working part is a Remover. Otherwise
// its working parts are the parts that model.parts names. If model.parts is empty, the tool gets
// the parts of its kind, model.kind. Throws Error if the name of a kind or part is unknown; the
// message lists the known names. Also throws Error if the model's mesh or numbers are wrong.
std::unique_ptr<Tool> makeTool(ToolModel model);

}  // namespace resect
