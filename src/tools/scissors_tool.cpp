#include "tools/scissors_tool.h"

#include "tools/responses.h"

namespace resect {

void ScissorsTool::act(const ToolContacts& contacts, std::vector<TissueEdit>& edits) const {
  if (removes(contacts)) return removeTouched(contacts, edits);
  partAlongEdges(contacts, edits);
}

}  // namespace resect
