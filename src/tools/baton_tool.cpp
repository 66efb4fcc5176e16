#include "tools/baton_tool.h"

#include "tools/responses.h"

namespace resect {

void BatonTool::act(const ToolContacts& contacts, std::vector<TissueEdit>& edits) const {
  if (removes(contacts)) removeTouched(contacts, edits);
}

}  // namespace resect
