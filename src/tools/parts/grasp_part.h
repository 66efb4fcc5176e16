// Working part of tissue forceps: when the tips close, they grip the tissue between them. The
// forceps then pull this tissue until the tips open.
//
// The forceps grip only tissue that is between the tips in the frame in which they close. Tissue
// that closed forceps touch later is not gripped. The simulation releases the gripped cells when
// the force on the grip exceeds ToolModel::slipForce, or when the tool is put away.
#pragma once

#include "tools/working_part.h"

namespace resect {

class GraspPart : public WorkingPart {
 public:
  void act(const Touch& touch, std::vector<TissueEdit>& edits) const override;
};

}  // namespace resect
