// Working part of a clamp for the vessels that bring blood to the liver (Pringle 1908). When the
// clamp is closed near the hilum, where these vessels enter the liver, it shuts the portal vein and
// the hepatic artery. Both vessels stay shut when the hand lets go. They open when the clamp is
// opened near the hilum, or closed there once more.
#pragma once

#include "tools/working_part.h"

namespace resect {

class InflowClampPart : public WorkingPart {
 public:
  void act(const Touch& touch, std::vector<TissueEdit>& edits) const override;
};

}  // namespace resect
