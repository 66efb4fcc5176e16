// Working part of scissors: two edges that cut the tissue between them while they close. The tool
// may move in any way at the same time. Contact with tissue is always computed from the shape with
// wide open jaws, even while the jaws are closed.
#pragma once

#include "tools/working_part.h"

namespace resect {

class JawsPart : public WorkingPart {
 public:
  void act(const Touch& touch, std::vector<TissueEdit>& edits) const override;
  void addEdges(const ToolModel& tool, const ToolWay& way,
                std::vector<CuttingEdge>& edges) const override;
};

}  // namespace resect
