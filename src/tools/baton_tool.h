// A blunt bar: it pushes tissue and never cuts. What does not move it takes out, as the original
// system did.
#pragma once

#include "tools/tool.h"

namespace resect {

class BatonTool : public Tool {
 public:
  using Tool::Tool;
  void act(const ToolContacts& contacts, std::vector<TissueEdit>& edits) const override;
};

}  // namespace resect
