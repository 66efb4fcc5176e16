// Makes the drawn parts of an instrument, which viewers show, from the parts of its model file.
#pragma once

#include <vector>

#include "io/model.h"
#include "tools/tool.h"

namespace resect {

// Returns one drawn part per part of the model, with the part's finish if the file gives one. If
// the file gives a normal to every point of the part, points and normals are taken unchanged.
// Otherwise the part is welded (geometry/repair/weld.h), so that viewers can compute smooth normals
// from its triangles. If the surface is closed but oriented inwards, its triangles are flipped. A
// part that has no triangles after welding is left out.
//
// If jaws.opening > 0, parts whose names begin with JawUpper or JawLower are jaws. The model has
// them wide open: JawUpper is turned by +jaws.opening / 2 about the axis jaws.axis through
// jaws.pivot, JawLower by -jaws.opening / 2. In the result they are closed, and DrawnPart::opens is
// the angle by which each of them opens. Throws Error if any other name begins with Jaw.
std::vector<DrawnPart> drawnParts(const Model& model, const Jaws& jaws);

}  // namespace resect
