// Converts lengths with units, such as "5mm", to metres.
#pragma once

#include <string>
#include <string_view>

namespace resect {

// The length in metres of a number with a unit (um, mm, cm, m, in, inch), such as "5mm" or "0.5
// cm". A number without a unit is in metres. Throws a usage Error that names `what` (such as
// "--spacing") if the text is not a finite length.
double parseLength(std::string_view text, std::string_view what);

// Metres per unit. "mm" gives 0.001, "cm" 0.01, "m" 1, "um" 1e-6, "in" or "inch" 0.0254. A plain
// number that lies in the range ranges::kUnit is returned unchanged. For any other text, throws a
// usage Error that names `what`.
double parseUnit(std::string_view text, std::string_view what);

// A length as text for people, such as "5 mm". It has three significant digits. Lengths below 10 cm
// are given in mm, other lengths in m.
std::string lengthText(double metres);

}  // namespace resect
