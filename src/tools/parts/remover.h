// Working part that removes each particle (cell of tissue) that its instrument touches, as all
// instruments did in the diploma thesis that Resect continues. Any instrument can have this part.
#pragma once

#include "tools/working_part.h"

namespace resect {

class Remover : public WorkingPart {
 public:
  void act(const Touch& touch, std::vector<TissueEdit>& edits) const override {
    for (const std::int64_t cell : touch.contacts.cells)
      edits.push_back(touch.edit(RemoveCell{cell}));
  }
};

}  // namespace resect
