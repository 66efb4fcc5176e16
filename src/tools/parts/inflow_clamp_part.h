// Working part of a clamp for the inflow of the liver (Pringle 1908). When it is closed near the
// liver's hilum, it shuts the portal vein and the hepatic artery. They stay shut until it is opened
// there again.
#pragma once

#include "tools/working_part.h"

namespace resect {

class InflowClampPart : public WorkingPart {
 public:
  void act(const Touch& touch, std::vector<TissueEdit>& edits) const override;
};

}  // namespace resect
