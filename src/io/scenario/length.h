// Parses lengths with units, such as "5mm", to metres.
#pragma once

#include <string>
#include <string_view>

namespace resect {

// A number and a unit (um, mm, cm, m, in), e.g. "5mm", "0.5 cm", "0.005m"; no unit means metres.
// Throws a usage Error that names `what` (such as "--spacing") if the text is no finite length.
double parseLength(std::string_view text, std::string_view what);

// Metres per unit: "mm" 0.001, "cm" 0.01, "m" 1, "um" 1e-6, "in" or "inch" 0.0254, or a plain
// number > 0. Throws a usage Error that names `what` for any other text.
double parseUnit(std::string_view text, std::string_view what);

// The length for people, such as "5 mm": three digits, in mm below 10 cm, else in m.
std::string lengthText(double metres);

}  // namespace resect
