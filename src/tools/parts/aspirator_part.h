// Working part of an ultrasonic aspirator: it breaks up soft tissue at its tip and draws it off. It
// leaves vessels with a diameter of at least 1 mm, since their walls are tough.
#pragma once

#include "tools/working_part.h"

namespace resect {

class AspiratorPart : public WorkingPart {
 public:
  void act(const Touch& touch, std::vector<TissueEdit>& edits) const override;
};

}  // namespace resect
