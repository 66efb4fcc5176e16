// A blade: it parts tissue along the way of its edge and pushes with its flat. What does not move
// it takes out, as the original system did.
#pragma once

#include "tools/tool.h"

namespace resect {

class ScalpelTool : public Tool {
 public:
  using Tool::Tool;
  void act(const ToolContacts& contacts, std::vector<TissueEdit>& edits) const override;
};

}  // namespace resect
