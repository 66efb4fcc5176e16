// Working part of an ultrasonic aspirator: its tip breaks up soft tissue and sucks up the
// fragments. Vessels with a diameter of at least 1 mm stay, since their walls are tough.
#pragma once

#include "tools/working_part.h"

namespace resect {

// How far from its tip the aspirator takes tissue, m: 4.8 mm, or 0.6 cells if these are larger.
// spacing: side of a cell, m.
double aspiratorReach(double spacing);

class AspiratorPart : public WorkingPart {
 public:
  void act(const Touch& touch, std::vector<TissueEdit>& edits) const override;
};

}  // namespace resect
