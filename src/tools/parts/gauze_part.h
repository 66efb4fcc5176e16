// Working part of a gauze swab: the hand presses the swab on tissue. The pressure holds back the
// blood of the vessels under the swab, and the swab soaks up blood.
#pragma once

#include "tools/working_part.h"

namespace resect {

class GauzePart : public WorkingPart {
 public:
  void act(const Touch& touch, std::vector<TissueEdit>& edits) const override;
};

}  // namespace resect
