#include "tools/registry.h"

#include <array>
#include <string>

#include "base/error.h"
#include "tools/baton_tool.h"
#include "tools/hook_tool.h"
#include "tools/scalpel_tool.h"
#include "tools/scissors_tool.h"

namespace resect {
namespace {

template <typename T>
std::unique_ptr<Tool> make(ToolModel model) {
  return std::make_unique<T>(std::move(model));
}

constexpr std::array<ToolKind, 4> kToolKinds = {{
    {"scalpel", make<ScalpelTool>},
    {"hook", make<HookTool>},
    {"baton", make<BatonTool>},
    {"scissors", make<ScissorsTool>},
}};

}  // namespace

std::span<const ToolKind> toolKinds() { return kToolKinds; }

std::unique_ptr<Tool> makeTool(ToolModel model) {
  for (const ToolKind& kind : kToolKinds)
    if (kind.name == model.kind) return kind.make(std::move(model));
  std::string known;
  for (const ToolKind& kind : kToolKinds)
    known += (known.empty() ? "" : ", ") + std::string(kind.name);
  throw error("there is no kind of tool \"{}\" (tool \"{}\"); use one of: {}", model.kind,
              model.name, known);
}

}  // namespace resect
