// Whether the ends of cut vessels are closed, and which clips slip off.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "anatomy/vessel_state.h"

namespace resect {

// Distance along the vessels from an end of an injury to a clip, m. None if the clip does not close
// this end or is farther away than `reach`, m. The clip may be on the injured segment or on another
// segment: for the root end on one that feeds the injured segment, for the far end on one that the
// injured segment feeds.
std::optional<double> wayToClip(const Anatomy& anatomy, const VesselInjury& injury, VesselEnd end,
                                const VesselClip& clip, double reach);

// Whether an end of a cut vessel is sealed, or closed by a clip that is at most `reach` away, m. An
// end that bleeds is not closed by a clip on another segment.
bool isClosed(const Anatomy& anatomy, const VesselState& state, const VesselInjury& injury,
              VesselEnd end, double reach = 0.03);
// Whether no end of an injury can bleed. A hole in the wall has only the root end.
bool isClosed(const Anatomy& anatomy, const VesselState& state, const VesselInjury& injury);

// A clip slips off if the vessel is severed closer to it than this, m: then the clip has no stump
// to hold. Textbooks ask for a stump of some millimetres; the figure is an estimate.
inline constexpr double kLeastStump = 0.0015;

// Removes the clips that slip off the vessels in `cut`, segments that were just cut. Walls that
// heat has welded do not slip. Returns the clips that were removed.
std::vector<VesselClip> slipClips(const Anatomy& anatomy, const std::vector<std::int32_t>& cut,
                                  VesselState& state);

}  // namespace resect
