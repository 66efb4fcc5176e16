// Working part of tissue forceps: as the tips close they grip the tissue between them, so that the
// forceps pull it; as they open they release it.
//
// Forceps that close away from tissue hold nothing, and nothing that they meet later while they are
// closed. The simulation releases the cells when the force on the grip exceeds
// ToolModel::slipForce, or when the tool is put away.
#pragma once

#include "tools/working_part.h"

namespace resect {

class GraspPart : public WorkingPart {
 public:
  void act(const Touch& touch, std::vector<TissueEdit>& edits) const override;
};

}  // namespace resect
