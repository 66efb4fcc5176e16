// Working part of bipolar forceps: while the tips are closed, current flows through the tissue
// between them. No pedal is needed: the generator starts automatically. The heat of the current
// seals vessels and stops oozing.
#pragma once

#include "tools/working_part.h"

namespace resect {

// Value of ToolStance::squeeze from which current flows.
inline constexpr double kBipolarCloses = 0.9;
// Greatest distance from the tips at which a bleeding vessel end is heated, m.
inline constexpr double kBipolarTakes = 0.006;

class BipolarPart : public WorkingPart {
 public:
  void act(const Touch& touch, std::vector<TissueEdit>& edits) const override;
};

}  // namespace resect
