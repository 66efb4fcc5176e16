// Working part of a hook: grips the cells in the hook's bend, so that the hook pulls them.
//
// The part grips in a frame in which the hook moves towards its handle and holds no cell of the
// organ yet. The simulation releases the gripped cells when the force on the grip exceeds
// ToolModel::slipForce, or when the tool is put away.
#pragma once

#include "tools/working_part.h"

namespace resect {

class HookPart : public WorkingPart {
 public:
  void act(const Touch& touch, std::vector<TissueEdit>& edits) const override;
};

}  // namespace resect
