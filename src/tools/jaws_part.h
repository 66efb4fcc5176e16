// Two edges that part what is between them as they close, wherever the tool goes meanwhile. Tissue
// feels the surface of open jaws throughout.
#pragma once

#include "tools/working_part.h"

namespace resect {

class JawsPart : public WorkingPart {
 public:
  void act(const Touch& touch, std::vector<TissueEdit>& edits) const override;
};

}  // namespace resect
