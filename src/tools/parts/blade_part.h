// Working part with a cutting edge. It cuts tissue where the edge passes, and removes none.
#pragma once

#include "tools/working_part.h"

namespace resect {

class BladePart : public WorkingPart {
 public:
  void act(const Touch& touch, std::vector<TissueEdit>& edits) const override;
  void addEdges(const ToolModel& tool, const ToolWay& way,
                std::vector<CuttingEdge>& edges) const override;
};

}  // namespace resect
