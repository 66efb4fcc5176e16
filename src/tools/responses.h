// What instruments can do to tissue, ready to be put together into a tool's response.
#pragma once

#include "tools/tool.h"

namespace resect {

// The response of the thesis, open to every tool: each particle that it touches is taken out.
void removeTouched(const ToolContacts& contacts, std::vector<TissueEdit>& edits);

// Tissue is parted where the tool's edges have passed through it; nothing is taken out.
void partAlongEdges(const ToolContacts& contacts, std::vector<TissueEdit>& edits);

}  // namespace resect
