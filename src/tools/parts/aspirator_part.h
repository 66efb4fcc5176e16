// Working part of an ultrasonic aspirator: its tip breaks up soft tissue and sucks up the
// fragments. Vessels with a diameter of at least 1 mm stay, since their walls are tough.
#pragma once

#include "tools/working_part.h"

namespace resect {

class AspiratorPart : public WorkingPart {
 public:
  void act(const Touch& touch, std::vector<TissueEdit>& edits) const override;
};

}  // namespace resect
