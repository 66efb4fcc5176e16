// Rejects nodes of a scene with invalid or excessive counts.
#pragma once

#include <string>

class SoCallbackAction;
class SoNode;

namespace resect {

// To be called for every node before it is traversed. Throws an Error, beginning with `path`, for
// what makes Coin 4.0.0 crash or run without end: an Array or MultipleCopy of more than 10 000
// copies; a NURBS surface whose control points or knots are missing or out of range; a profile that
// uses a missing point; an elevation grid with too few heights; an extrusion without scales or
// orientations, or of more than 10 000 000 points.
void checkNodeLimits(const SoNode& node, SoCallbackAction& action, const std::string& path);

}  // namespace resect
