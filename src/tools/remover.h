// The response of the thesis, open to every instrument: each particle that it touches is taken out.
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
