// Working part of a suction tube: while the tube is in hand, it sucks up the blood near its tip.
#pragma once

#include "tools/working_part.h"

namespace resect {

class SuctionPart : public WorkingPart {
 public:
  void act(const Touch& touch, std::vector<TissueEdit>& edits) const override;
};

}  // namespace resect
