// Tells whether a model has the size of an organ, and guesses the unit of its coordinates.
#pragma once

#include <string>

#include "base/error.h"
#include "geometry/aabb.h"

namespace resect {

// Whether a box in metres has the size of an organ: its longest side is 0.02 to 1 m.
bool isOrganSized(const Aabb& box);

// box: in the file's own numbers. Returns a unit: "um", "mm", "cm" or "m". It is the unit with
// which the ratio of the box's longest side to the length of a liver (0.2 m) is nearest to 1. Empty
// if all sides are 0.
std::string plausibleUnit(const Aabb& box);

// The unit in which the model would have the size of an organ. Empty if the model already has the
// size of an organ, or if it would not have this size in any unit. The arguments are the same as
// those of sizeDoubt().
std::string unitHint(const Aabb& box, double metresPerUnit);

// Empty if the box has the size of an organ. Otherwise a sentence that gives the size. If the model
// would have the size of an organ in another unit, the sentence names this unit: "its longest side
// is 200 m, which is no organ's; in mm it would be 200 mm: add --unit mm". All messages about a
// wrong size come from this function. box: of the model, m. metresPerUnit: the factor by which the
// file's numbers were multiplied.
std::string sizeDoubt(const Aabb& box, double metresPerUnit);

// Returns the Error with `doubt`, a sentence from sizeDoubt(), added at the end; if `doubt` is
// empty, returns the Error unchanged. It often happens that a model causes an Error because its
// unit is not the assumed unit.
Error withDoubt(const Error& error, const std::string& doubt);

}  // namespace resect
