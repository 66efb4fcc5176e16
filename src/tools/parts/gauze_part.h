// Working part of a gauze swab: pressed on tissue, it holds back the blood of the vessels under it
// by the pressure of the hand, and it soaks up blood.
#pragma once

#include "tools/working_part.h"

namespace resect {

class GauzePart : public WorkingPart {
 public:
  void act(const Touch& touch, std::vector<TissueEdit>& edits) const override;
};

}  // namespace resect
