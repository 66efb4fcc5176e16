// Working part with a cutting edge: parts tissue where the edge passes, removes nothing. The flat
// of a blade pushes.
//
// Only motion within the blade's plane parts tissue: moving sideways the blade pushes, moving back
// it only leaves the cut. The motion of the frame before is tested again, since tissue may have
// moved through the edge meanwhile.
#pragma once

#include "tools/working_part.h"

namespace resect {

class BladePart : public WorkingPart {
 public:
  void act(const Touch& touch, std::vector<TissueEdit>& edits) const override;
};

}  // namespace resect
