// Converts ways of instruments, given in an organ's coordinates (operation/way/organ_way.h), to
// keys in world coordinates (ToolKey). A key is the pose of an instrument at one time.
#pragma once

#include "operation/scenario.h"

namespace resect {

// An organ as it lies in the room: the data that are needed to convert ways.
struct LaidOrgan {
  // Closed surface of the organ; world, m. For an organ at rest it is the surface of the model, if
  // there is a model. So ways do not depend on the cells.
  TriangleMesh surface;
  std::vector<Landmark> landmarks;  // in fractions of its box
  Vec3 cell = Vec3::Zero();         // sides of its cells, m
};

// Greatest depth to which a way leads, as a fraction of the organ's greatest height in its section
// at the way's x (operation/way/organ_section.h).
inline constexpr double kDeepestShare = 0.5;

// Whether any tool has a way.
bool hasWays(const Scenario& scenario);

// Converts each way that refers to this organ to keys of its tool. If Scenario::after is given,
// sets the scenario's duration (endAfterKeys()). organ: the organ's number in the scenario. The
// ways are kept, so that they can be converted again when the organ is replaced.
// - A way leads no deeper than kDeepestShare, and not below the lowest point of the section.
// - Positions are rounded to 0.01 mm and times to 0.01 ms, so that the keys do not depend on the
//   last bits of the surface. The time from the previous key to a key with a speed is a whole
//   number of frames.
// Throws Error if a way names a landmark that the organ lacks, or if the organ has no surface.
void placeWays(Scenario& scenario, std::size_t organ, const LaidOrgan& laid);

// Converts the ways on elastic organs again, after these organs have sunk under their own weight.
// For this, frames are computed until the first tool comes below the top of its organ, but at most
// for the time kSettling. Then placeWays() is called with the present surfaces of the elastic
// organs. If these organs have more than kMostSettled particles together, nothing is done, since
// the frames would take too long. simulation: made from the scenario, before its first frame. It is
// restored to this state at the end. Cost: the cost of the computed frames.
inline constexpr double kSettling = 1.5;             // s
inline constexpr std::int64_t kMostSettled = 16000;  // particles of all elastic organs
void settleWays(Scenario& scenario, Simulation& simulation);

}  // namespace resect
