// A hook: it catches the tissue in its bend while it is pulled and holds it until the pull is too
// much (ToolModel::slipForce). What does not move it takes out, as the original system did.
#pragma once

#include "tools/tool.h"

namespace resect {

class HookTool : public Tool {
 public:
  using Tool::Tool;
  void act(const ToolContacts& contacts, std::vector<TissueEdit>& edits) const override;
};

}  // namespace resect
