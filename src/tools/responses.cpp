#include "tools/removing_tool.h"

namespace resect {

void removeTouched(const ToolContacts& contacts, std::vector<TissueEdit>& edits) {
  for (const std::int64_t cell : contacts.cells)
    edits.push_back({TissueEdit::Kind::Remove, contacts.tool, cell, -1});
}

}  // namespace resect
