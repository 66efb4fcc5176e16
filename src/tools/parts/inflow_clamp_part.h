// Working part of a clamp for the inflow of the liver: closed on the tape round the vessels at its
// hilum, it shuts portal vein and artery until it is opened again there (Pringle 1908).
#pragma once

#include "tools/working_part.h"

namespace resect {

class InflowClampPart : public WorkingPart {
 public:
  void act(const Touch& touch, std::vector<TissueEdit>& edits) const override;
};

}  // namespace resect
