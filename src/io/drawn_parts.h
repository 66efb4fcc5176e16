// Makes what viewers draw of an instrument from the parts of its model.
#pragma once

#include <vector>

#include "io/model.h"
#include "tools/tool.h"

namespace resect {

// Every part with its normals, if the file gives one to every point, else welded, so that normals
// can be made from its triangles; with the file's finish, if any. A part without proper triangles
// is left out.
//
// Parts whose names begin with JawUpper and JawLower are jaws, which the model shows wide open:
// JawUpper by +jaws.opening / 2 about jaws.axis through jaws.pivot, JawLower by as much the other
// way. An Error for another name that begins with Jaw. Without an opening no part is a jaw.
std::vector<DrawnPart> drawnParts(const Model& model, const Jaws& jaws);

}  // namespace resect
