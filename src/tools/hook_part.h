// A hook: it catches the tissue in its bend while it is pulled towards its handle, and holds it
// until the pull is too much (ToolModel::slipForce). One catch per pull: what it holds is not added
// to.
#pragma once

#include "tools/working_part.h"

namespace resect {

class HookPart : public WorkingPart {
 public:
  void act(const Touch& touch, std::vector<TissueEdit>& edits) const override;
};

}  // namespace resect
