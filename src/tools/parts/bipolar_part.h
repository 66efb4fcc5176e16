// Working part of bipolar forceps: when the tips are closed, current flows through what is between
// them, as generators with automatic start do it. Its heat seals vessels and stops oozing.
#pragma once

#include "tools/working_part.h"

namespace resect {

class BipolarPart : public WorkingPart {
 public:
  void act(const Touch& touch, std::vector<TissueEdit>& edits) const override;
};

}  // namespace resect
