// Working part of a hook. When the hook moves towards its handle in a frame and holds no cell of
// the organ yet, it grips the cells in its bend. The cells are released when the pull exceeds
// ToolModel::slipForce, or when the tool is put away.
#pragma once

#include "tools/working_part.h"

namespace resect {

class HookPart : public WorkingPart {
 public:
  void act(const Touch& touch, std::vector<TissueEdit>& edits) const override;
};

}  // namespace resect
