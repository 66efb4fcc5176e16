#include "tools/removing_tool.h"

namespace resect {

void RemovingTool::act(const ToolContacts& contacts, std::vector<TissueEdit>& edits) const {
  for (const std::int64_t cell : contacts.cells)
    edits.push_back({TissueEdit::Kind::Remove, contacts.tool, cell});
}

}  // namespace resect
