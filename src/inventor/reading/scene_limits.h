// Rejects scene nodes whose counts are invalid or too large.
#pragma once

#include <string>

class SoCallbackAction;
class SoNode;

namespace resect {

// Call this for every node before Coin (the Inventor library) traverses the node. action: the
// traversal that has reached the node. If the node would make Coin 4.0.0 crash or run without end,
// throws an Error that begins with `path`. Such nodes are:
// - an Array or MultipleCopy of more than 10 000 copies;
// - a NURBS surface with control points or knots that are missing, too many or out of range;
// - a profile node that uses the index of a point that does not exist;
// - an elevation grid with too few heights;
// - an extrusion that has no scales, no orientations, or more than 10 000 000 points.
void checkNodeLimits(const SoNode& node, SoCallbackAction& action, const std::string& path);

}  // namespace resect
