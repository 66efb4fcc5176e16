// Tells whether a model has the size of an organ, and guesses the unit of its coordinates.
#pragma once

#include <string>

#include "base/error.h"
#include "geometry/aabb.h"

namespace resect {

// Whether a box in metres has the size of an organ: its longest side is 0.02 to 1 m.
bool isOrganSized(const Aabb& box);

// box: in the file's own numbers. Returns the unit, "um", "mm", "cm" or "m", in which the longest
// side of the box is nearest, by ratio, to that of a liver (0.2 m). Empty if all sides are 0.
std::string plausibleUnit(const Aabb& box);

// The unit in which the model would have the size of an organ. Empty if the model already has that
// size, or would not have it in any unit. Arguments as for sizeDoubt().
std::string unitHint(const Aabb& box, double metresPerUnit);

// Empty if the box has the size of an organ. Otherwise a sentence with the size and, if the model
// would have the size of an organ in another unit, with that unit: "its longest side is 200 m,
// which is no organ's; in mm it would be 200 mm: add --unit mm". All messages about a wrong size
// come from this function. box: of the model, m. metresPerUnit: the factor by which the file's
// numbers were multiplied.
std::string sizeDoubt(const Aabb& box, double metresPerUnit);

// The same Error with `doubt` (sizeDoubt()), if any, at its end. A model that causes an Error is
// often in another unit than was assumed.
Error withDoubt(const Error& error, const std::string& doubt);

}  // namespace resect
