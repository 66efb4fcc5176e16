// Rejects scene nodes whose counts are invalid or too large.
#pragma once

#include <string>

class SoCallbackAction;
class SoNode;

namespace resect {

// To be called for every node before it is traversed. action: the traversal in which the node was
// reached. Throws an Error, beginning with `path`, for a node that makes Coin 4.0.0 crash or run
// without end:
// - an Array or MultipleCopy of more than 10 000 copies;
// - a NURBS surface with control points or knots that are missing, too many or out of range;
// - a profile that uses a missing point;
// - an elevation grid with too few heights;
// - an extrusion without scales or orientations, or of more than 10 000 000 points.
void checkNodeLimits(const SoNode& node, SoCallbackAction& action, const std::string& path);

}  // namespace resect
