// The walls of wide vessels as cords in the tissue. A cord is a spring between two cells that pulls
// when it is stretched (tissue/cord.h).
//
// The Young's modulus of parenchyma is several kilopascals; the modulus of a vessel's wall is about
// a hundred times as large. So a wide vessel stiffens the cells through which it runs, in the
// vessel's direction. A vessel that was bared in a wound holds the two sides of the wound together
// until the vessel is divided.
#pragma once

#include <vector>

#include "organ/edit.h"
#include "organ/operated_organ.h"

namespace resect {

// Young's modulus of a vessel's wall, Pa: veins of the liver at small strain (Umale et al. 2011,
// doi:10.1016/j.jbiomech.2011.03.029: 0.62 +- 0.41 MPa).
inline constexpr double kWallModulus = 0.62e6;
// m: a vessel inside the tissue is a cord if its radius is at least this. The effect of thinner
// vessels is already part of the stiffness that was measured on tissue. Bared segments, and the
// segments next to them along the vessel, are cords at any radius.
inline constexpr double kWideVessel = 1.5e-3;

// A vessel breaks when it is stretched to this multiple of its length at rest (estimate).
inline constexpr double kBreakStretch = 1.8;
// m: where tissue tears, vessels of at least this radius stay whole. Crushing the liver between
// fingers or the jaws of a clamp bares vessels with a diameter of about 2 mm or more.
inline constexpr double kTornVessel = 1e-3;

// The cords of the organ's vessels. A vessel passes through several cells of tissue, and a cord
// leads from each of these cells to the next. Where tissue was removed, a cord leads from one side
// of the gap to the other. There is no cord across the cut of a severed vessel. Stiffness:
// cross-sectional area of the wall times kWallModulus, divided by the distance between the cells.
// Cost: some ns per segment, and 100 ns per spacing of the length of all cords together.
std::vector<VesselCord> vesselCords(const Organ& organ, const TissueModel& tissue);

// Computes the cords again, and gives them to the tissue. Call after edits and after a restore.
void renewCords(OperatedOrgan& organ);

// Edits that divide all vessels that are stretched beyond kBreakStretch.
std::vector<DivideVessel> brokenVessels(const OperatedOrgan& organ);

}  // namespace resect
