// Turns the ways of instruments that are given in an organ's coordinates into keys in the world.
#pragma once

#include "operation/scenario.h"

namespace resect {

// The data of an organ, as it lies in the room, to which ways refer.
struct LaidOrgan {
  // Closed; world, m. For an organ at rest it is the surface of the model, if there is one, so that
  // ways do not depend on the cells.
  TriangleMesh surface;
  std::vector<Landmark> landmarks;  // in fractions of its box
  Vec3 cell = Vec3::Zero();         // sides of its cells, m
};

// Greatest depth to which a way leads, as a share of the organ's greatest height in the section.
inline constexpr double kDeepestShare = 0.5;

// Whether any tool has a way.
bool hasWays(const Scenario& scenario);

// Converts the way of each tool whose way refers to this organ to keys of the tool. If
// Scenario::after is given, sets the scenario's duration (endAfterKeys()). organ: its number in the
// scenario. The way is kept, so that it can be placed anew when the organ is replaced.
// - Depths are limited: to kDeepestShare, and to the lowest point of the section.
// - Positions are rounded to 0.01 mm and times to 0.01 ms, so that the keys do not depend on the
//   last bits of the surface. The time from the previous key to a key with a speed is a whole
//   number of frames.
// Throws Error if a way names a landmark that is not there, or if the organ has no surface.
void placeWays(Scenario& scenario, std::size_t organ, const LaidOrgan& laid);

// Places the ways on elastic organs again. Elastic tissue sinks under its own weight before the
// first tool touches it. So the ways are placed on the surface as it is when the first tool comes
// below the organ's top, or after kSettling if that is earlier. With more than kMostSettled
// particles this would take long; the ways then stay on the organ at rest. simulation: made from
// the scenario, before its first frame; its state is the same afterwards. Cost: that of the frames
// until then.
inline constexpr double kSettling = 1.5;             // s
inline constexpr std::int64_t kMostSettled = 16000;  // particles of all elastic organs
void settleWays(Scenario& scenario, Simulation& simulation);

}  // namespace resect
