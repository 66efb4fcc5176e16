// Volumes of blood as whole picolitres. Sums of such volumes are exact, so no blood is lost or
// created.
#pragma once

#include <cstdint>

namespace resect {

using Picolitres = std::int64_t;
inline constexpr double kPicolitresPerM3 = 1e15;

// Rounds down to whole picolitres. volume: m^3, up to 9000 m^3.
inline Picolitres toPicolitres(double volume) { return Picolitres(volume * kPicolitresPerM3); }
inline double toCubicMetres(Picolitres volume) { return double(volume) / kPicolitresPerM3; }

}  // namespace resect
