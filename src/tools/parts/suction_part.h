// Working part of a suction tube: while it is in hand, it takes the blood near its tip.
#pragma once

#include "tools/working_part.h"

namespace resect {

class SuctionPart : public WorkingPart {
 public:
  void act(const Touch& touch, std::vector<TissueEdit>& edits) const override;
};

}  // namespace resect
