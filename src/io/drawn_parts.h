// Makes the drawn parts of an instrument from the parts of its model file. Viewers show the drawn
// parts.
#pragma once

#include <vector>

#include "io/model.h"
#include "tools/tool.h"

namespace resect {

// Returns one drawn part for each part of the model. A finish is the colour and gloss of a surface
// (tools/finish.h). If the file gives a finish for the part, the drawn part gets this finish. If
// the file gives a normal for every point of the part, points and normals are taken unchanged.
// Otherwise the part is welded (geometry/repair/weld.h), so that viewers can compute smooth normals
// from its triangles. If the part's surface is closed but oriented inwards, its triangles are
// flipped. A part that has no triangles after welding is left out.
//
// If jaws.opening > 0, parts whose names begin with JawUpper or JawLower are jaws. In the model the
// jaws are wide open: about the axis jaws.axis through the point jaws.pivot, JawUpper is turned by
// +jaws.opening / 2, and JawLower is turned by -jaws.opening / 2. In the result the jaws are
// closed, and DrawnPart::opens is the angle by which the jaw opens. Throws Error if another part
// has a name that begins with Jaw.
std::vector<DrawnPart> drawnParts(const Model& model, const Jaws& jaws);

}  // namespace resect
