// The response of the thesis: every particle that the tool touches is taken out.
#pragma once

#include "tools/tool.h"

namespace resect {

class RemovingTool : public Tool {
 public:
  using Tool::Tool;
  void act(const ToolContacts& contacts, std::vector<TissueEdit>& edits) const override;
};

}  // namespace resect
