// Working part of a clip applier: when its jaws close, it puts a clip on a vessel between the jaws
// or near them.
#pragma once

#include "tools/working_part.h"

namespace resect {

inline constexpr double kClipCloses = 0.95;    // value of ToolStance::squeeze that shuts the clip
inline constexpr double kTrickle = 1e-6 / 60;  // m^3/s, 1 ml/min: weaker bleeding gets no clip
inline constexpr double kClipReach = 0.008;  // m: greatest distance of a vessel from the tool's tip
// Whether a clip closes a vessel of this radius, m, and stays on it.
inline bool holdsClip(double radius) { return radius >= 0.3e-3 && radius <= 3.5e-3; }

class ClipPart : public WorkingPart {
 public:
  void act(const Touch& touch, std::vector<TissueEdit>& edits) const override;
};

}  // namespace resect
