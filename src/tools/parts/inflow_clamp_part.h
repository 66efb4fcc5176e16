// Working part of a clamp for the inflow of the liver (Pringle 1908). When the clamp is closed near
// the liver's hilum, it shuts the portal vein and the hepatic artery. These vessels stay shut until
// the clamp is opened near the hilum, or closed there once more: a hand that lets go leaves the
// clamp on.
#pragma once

#include "tools/working_part.h"

namespace resect {

class InflowClampPart : public WorkingPart {
 public:
  void act(const Touch& touch, std::vector<TissueEdit>& edits) const override;
};

}  // namespace resect
