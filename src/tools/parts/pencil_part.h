// Working part of a monopolar pencil: its electrode cuts by heat, almost without force, and seals
// the thin vessels that it cuts. It cuts while its pedal is released. While its pedal is pressed,
// sparks from its tip coagulate the tissue's surface, and it does not cut.
#pragma once

#include "tools/working_part.h"

namespace resect {

class PencilPart : public WorkingPart {
 public:
  void act(const Touch& touch, std::vector<TissueEdit>& edits) const override;
  void addEdges(const ToolModel& tool, const ToolWay& way,
                std::vector<CuttingEdge>& edges) const override;
};

}  // namespace resect
