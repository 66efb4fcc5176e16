// Working part of bipolar forceps: while the tips are closed, current flows through the tissue
// between them. No pedal is needed: the generator starts automatically. The heat of the current
// seals vessels and stops oozing.
#pragma once

#include "tools/working_part.h"

namespace resect {

// Current flows if ToolStance::squeeze is at least this value.
inline constexpr double kBipolarCloses = 0.9;
// A length, m. If a vessel bleeds at most this far from the tips, its bleeding end is heated.
// Otherwise the tissue at the tips is heated.
inline constexpr double kBipolarTakes = 0.006;

class BipolarPart : public WorkingPart {
 public:
  void act(const Touch& touch, std::vector<TissueEdit>& edits) const override;
};

}  // namespace resect
