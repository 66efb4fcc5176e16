// Working part of a clip applier: when its jaws close, it puts a clip on the vessel between them.
#pragma once

#include "tools/working_part.h"

namespace resect {

class ClipPart : public WorkingPart {
 public:
  void act(const Touch& touch, std::vector<TissueEdit>& edits) const override;
};

}  // namespace resect
