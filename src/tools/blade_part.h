// Working part with a cutting edge: it parts tissue where the edge passes, and removes nothing. The
// flat of the blade pushes tissue.
//
// Only motion within the blade's plane parts tissue. A blade that moves sideways pushes; one that
// moves backwards only leaves the cut. The sweep of the frame before counts once more, since tissue
// may have moved through the edge since then.
#pragma once

#include "tools/working_part.h"

namespace resect {

class BladePart : public WorkingPart {
 public:
  void act(const Touch& touch, std::vector<TissueEdit>& edits) const override;
};

}  // namespace resect
