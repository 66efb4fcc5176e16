// A cutting edge: tissue is parted where it passes, and nothing is taken out. With its flat a blade
// pushes.
//
// Only motion along the blade parts tissue: moving sideways it pushes, moving back it leaves by the
// way it came. The way of the frame before is tested again, for tissue may have moved through the
// edge meanwhile.
#pragma once

#include "tools/working_part.h"

namespace resect {

class BladePart : public WorkingPart {
 public:
  void act(const Touch& touch, std::vector<TissueEdit>& edits) const override;
};

}  // namespace resect
