// Working part with a cutting edge. It parts tissue where the edge passes, and removes nothing.
//
// Tissue is parted only if the edge moves mainly within the plane of the blade, and not backwards
// out of the cut. In other motions the blade only pushes the tissue that it meets, as other tools
// do. The sweep of the previous frame is used again together with that of this frame, since tissue
// may have moved through the edge in the meantime.
#pragma once

#include "tools/working_part.h"

namespace resect {

class BladePart : public WorkingPart {
 public:
  void act(const Touch& touch, std::vector<TissueEdit>& edits) const override;
};

}  // namespace resect
