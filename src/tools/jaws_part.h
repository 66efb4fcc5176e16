// Working part of scissors: two edges that part the tissue between them as they close, however the
// tool moves meanwhile. As an obstacle, the tool always has the shape of wide open jaws.
#pragma once

#include "tools/working_part.h"

namespace resect {

class JawsPart : public WorkingPart {
 public:
  void act(const Touch& touch, std::vector<TissueEdit>& edits) const override;
};

}  // namespace resect
