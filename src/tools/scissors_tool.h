// Scissors: they part what lies between their blades as these close. What does not move they take
// out, as the original system did.
#pragma once

#include "tools/tool.h"

namespace resect {

class ScissorsTool : public Tool {
 public:
  using Tool::Tool;
  void act(const ToolContacts& contacts, std::vector<TissueEdit>& edits) const override;
};

}  // namespace resect
