// The response of the thesis, open to every tool: each particle that it touches is taken out.
#pragma once

#include "tools/tool.h"

namespace resect {

void removeTouched(const ToolContacts& contacts, std::vector<TissueEdit>& edits);

}  // namespace resect
