// Turns the ways of instruments that are given in an organ's coordinates into keys in the world.
#pragma once

#include "operation/scenario.h"

namespace resect {

// What ways refer to: an organ as it lies in the room.
struct LaidOrgan {
  // Closed. At rest it is that of the model, if there is one, so that ways do not depend on the
  // cells.
  TriangleMesh surface;
  std::vector<Landmark> landmarks;  // in fractions of its box
  Vec3 cell = Vec3::Zero();         // sides of its cells, m
};

// No way leads deeper than this share of the organ's greatest height in the section there.
inline constexpr double kDeepestShare = 0.5;

// Whether any tool has a way.
bool hasWays(const Scenario& scenario);

// Gives each tool whose way is on this organ the keys that the way has there. If the scenario is to
// end some time after its last key (Scenario::after), sets its duration. organ: its number in the
// scenario. The way is kept, so that it can be placed anew when the organ is replaced.
// - Depths are limited: to kDeepestShare, and to the lowest point of the section.
// - Positions are rounded to 0.01 mm and times to 0.01 ms, so that the keys do not depend on the
//   last bits of the surface. A key that is reached with a speed falls on a frame.
// Throws Error if a way names a landmark that is not there, or if the organ has no surface.
void placeWays(Scenario& scenario, std::size_t organ, const LaidOrgan& laid);

// Elastic tissue sinks under its own weight before an instrument comes. This places the ways on
// elastic organs again, on the surface as it lies when the first tool comes, or after kSettling.
// With more than kMostSettled particles it would take long; the ways then stay on the organ at
// rest. `simulation` must be the scenario's, before its first frame, and is left as it was. Cost:
// that of the frames until then.
inline constexpr double kSettling = 1.5;             // s
inline constexpr std::int64_t kMostSettled = 16000;  // particles of all elastic organs
void settleWays(Scenario& scenario, Simulation& simulation);

}  // namespace resect
