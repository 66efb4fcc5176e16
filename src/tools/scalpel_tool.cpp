#include "tools/scalpel_tool.h"

#include "tools/removing_tool.h"

namespace resect {

void ScalpelTool::act(const ToolContacts& contacts, std::vector<TissueEdit>& edits) const {
  if (removes(contacts)) return removeTouched(contacts, edits);
  if (!contacts.nearBlade.empty()) edits.push_back({TissueEdit::Kind::Incise, contacts.tool});
  for (const TissueBond& bond : contacts.crossed)
    edits.push_back({TissueEdit::Kind::Sever, contacts.tool, bond.cell, bond.direction});
}

}  // namespace resect
