// Working part of a hook: in a frame in which it moves towards its handle and holds nothing of the
// organ, it grips the cells in its bend. It releases them when the pull exceeds
// ToolModel::slipForce, or when the tool is put away.
#pragma once

#include "tools/working_part.h"

namespace resect {

class HookPart : public WorkingPart {
 public:
  void act(const Touch& touch, std::vector<TissueEdit>& edits) const override;
};

}  // namespace resect
