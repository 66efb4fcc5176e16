// Rejects nodes of a scene with invalid or excessive counts.
#pragma once

#include <string>

class SoCallbackAction;
class SoNode;

namespace resect {

// Called for every node before it is traversed. Throws an Error, beginning with `path`, for what
// makes Coin 4.0.0 crash or never end: Array and MultipleCopy of more than 10 000 copies, NURBS
// surfaces whose control points or knots are missing or out of range, an elevation grid or
// extrusion with too few numbers.
void checkNodeLimits(const SoNode& node, SoCallbackAction& action, const std::string& path);

}  // namespace resect
