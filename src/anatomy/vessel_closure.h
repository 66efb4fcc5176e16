// Whether the ends of cut vessels are closed, and which clips slip off. A cut vessel segment is
// called an injury (anatomy/vessel_state.h).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "anatomy/vessel_state.h"

namespace resect {

// Distance along the vessels from an end of an injury to a clip, m. No value if the clip does not
// close this end or is farther away than `reach`, m. The clip may be on the injured segment or on
// another segment. For the root end, this other segment lies between the injury and the root of the
// tree. For the far end, it lies in the subtree behind the injury.
std::optional<double> wayToClip(const Anatomy& anatomy, const VesselInjury& injury, VesselEnd end,
                                const VesselClip& clip, double reach);

// Whether an end of a cut vessel is sealed, or closed by a clip that is at most `reach` away, m. If
// the end still bleeds, clips on other segments do not count.
bool isClosed(const Anatomy& anatomy, const VesselState& state, const VesselInjury& injury,
              VesselEnd end, double reach = 0.03);
// Whether all ends of an injury are closed. A hole in the wall has only the root end.
bool isClosed(const Anatomy& anatomy, const VesselState& state, const VesselInjury& injury);

// A clip slips off if the vessel is cut through at a smaller distance from the clip than this, m.
// The stump is then too short to hold the clip. Textbooks ask for a stump of some millimetres; the
// value used here is an estimate.
inline constexpr double kLeastStump = 0.0015;

// Removes the clips that slip off, and returns them. cut: indices of the segments that were just
// cut. Walls that heat has welded (VesselClip::byHeat) stay closed.
std::vector<VesselClip> slipClips(const Anatomy& anatomy, const std::vector<std::int32_t>& cut,
                                  VesselState& state);

}  // namespace resect
