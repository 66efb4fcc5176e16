// Working part of a hook: grips the tissue in its bend while it is pulled towards its handle, until
// the pull exceeds ToolModel::slipForce. It grips once per pull: what it holds is not added to.
#pragma once

#include "tools/working_part.h"

namespace resect {

class HookPart : public WorkingPart {
 public:
  void act(const Touch& touch, std::vector<TissueEdit>& edits) const override;
};

}  // namespace resect
