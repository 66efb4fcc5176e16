// Tells whether a body has the size of an organ, and guesses the unit that its author used.
#pragma once

#include <string>

#include "base/error.h"
#include "geometry/aabb.h"

namespace resect {

// Whether a box in metres has the size of an organ: its longest side is 0.02 to 1 m.
bool isOrganSized(const Aabb& box);

// box: in the file's own numbers. Returns the unit, "um", "mm", "cm" or "m", in which the longest
// side of the box is nearest, by ratio, to that of a liver (0.2 m). Empty for a box without size.
std::string plausibleUnit(const Aabb& box);

// The unit in which the body would have the size of an organ; empty if it has it, or has it in no
// unit. Arguments as for sizeDoubt().
std::string unitHint(const Aabb& box, double metresPerUnit);

// Every doubt about a size is put by this function. `box`: of the body, m; metresPerUnit: what its
// numbers were multiplied by. Empty if the box has the size of an organ; otherwise a sentence that
// says the size and, where another unit would make it an organ's, that unit: "its longest side is
// 200 m, which is no organ's; in mm it would be 200 mm: add --unit mm".
std::string sizeDoubt(const Aabb& box, double metresPerUnit);

// The same Error, with the doubt, if any, at the end: what is refused for its size is often in
// another unit.
Error withDoubt(const Error& error, const std::string& doubt);

}  // namespace resect
