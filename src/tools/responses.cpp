#include "tools/responses.h"

namespace resect {

void removeTouched(const ToolContacts& contacts, std::vector<TissueEdit>& edits) {
  for (const std::int64_t cell : contacts.cells)
    edits.push_back({TissueEdit::Kind::Remove, contacts.tool, cell, -1});
}

void partAlongEdges(const ToolContacts& contacts, std::vector<TissueEdit>& edits) {
  if (!contacts.nearBlade.empty()) edits.push_back({TissueEdit::Kind::Incise, contacts.tool});
  for (const TissueBond& bond : contacts.crossed)
    edits.push_back({TissueEdit::Kind::Sever, contacts.tool, bond.cell, bond.direction});
}

}  // namespace resect
