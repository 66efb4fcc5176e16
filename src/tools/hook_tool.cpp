#include "tools/hook_tool.h"

#include "tools/responses.h"

namespace resect {

void HookTool::act(const ToolContacts& contacts, std::vector<TissueEdit>& edits) const {
  if (removes(contacts)) return removeTouched(contacts, edits);
  // One catch per pull: what it holds is not added to while it moves.
  if (contacts.gripped > 0) return;
  for (const std::int64_t cell : contacts.caught)
    edits.push_back({TissueEdit::Kind::Grip, contacts.tool, cell, -1});
}

}  // namespace resect
