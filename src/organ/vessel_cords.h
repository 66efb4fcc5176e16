// The walls of wide vessels as cords in the tissue.
//
// Parenchyma is a gel of some kilopascals, the wall of a vessel a hundred times as stiff. So wide
// vessels stiffen the cells in which they run, along their way, and a vessel that was bared holds
// the two banks of the groove together until it is divided.
#pragma once

#include <vector>

#include "organ/edit.h"
#include "organ/operated_organ.h"

namespace resect {

// Young's modulus of a vessel's wall, Pa: veins of the liver at small strain (Umale et al. 2011,
// doi:10.1016/j.jbiomech.2011.03.029: 0.62 +- 0.41 MPa).
inline constexpr double kWallModulus = 0.62e6;
// m: radius from which a vessel inside the tissue is a cord. Thinner ones are part of what was
// measured as the tissue's own stiffness. Bared vessels are cords at any width.
inline constexpr double kWideVessel = 1.5e-3;

// A vessel breaks when it is stretched to so many times its length at rest (estimate).
inline constexpr double kBreakStretch = 1.8;
// m: tissue that tears leaves vessels of at least this radius whole. Crushing the liver between
// fingers or the jaws of a clamp bares vessels from some 2 mm on.
inline constexpr double kTornVessel = 1e-3;

// One cord for each step of a vessel from one cell of tissue to the next; where tissue was taken
// away, from bank to bank. A severed vessel has none across the cut. Stiffness: the area of the
// wall times kWallModulus over the distance of the cells. Cost: some ns per segment, and 50 ns per
// half cell of wide vessels.
std::vector<VesselCord> vesselCords(const Organ& organ, const TissueModel& tissue);

// Finds the cords anew, and gives them to the tissue. Call after edits and after a restore.
void renewCords(OperatedOrgan& organ);

// Vessels that are stretched beyond kBreakStretch: edits that divide them.
std::vector<DivideVessel> brokenVessels(const OperatedOrgan& organ);

}  // namespace resect
