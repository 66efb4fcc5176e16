// Pressures and resistances of the blood supply of a liver, and properties of blood.
#pragma once

namespace resect {

inline constexpr double kMmHg = 133.322;           // Pa
inline constexpr double kBloodDensity = 1060;      // kg/m^3
inline constexpr double kBloodViscosity = 3.5e-3;  // Pa s
inline constexpr double kEarth = 9.81;             // gravity, m/s^2

// The supply of one kind of vessel: a source at constant pressure behind a resistance, and the flow
// through an organ without injuries. The flow of the hepatic veins is negative, since it leaves the
// organ.
struct Supply {
  double pressure = 0;    // of the source, Pa
  double resistance = 0;  // between the source and the root of the tree, Pa s/m^3
  double flow = 0;        // into the organ, m^3/s
};

// The pressure of each source, divided by its value at rest.
struct SourceShares {
  double artery = 1, portal = 1, vein = 1;
};

// Values at rest. 1.5 l/min flow through the organ, a quarter from the artery and three quarters
// from the portal vein. The pressures are 8 mmHg in the portal vein, 3 in the vena cava and 5 in
// the sinusoids (docs/methods/blood.md).
struct Circulation {
  Supply portal{90 * kMmHg, 4.37e6 * kMmHg, 18.75e-6};
  Supply hepatic{3 * kMmHg, 0.02e6 * kMmHg, -25e-6};
  Supply artery{95 * kMmHg, 0.8e6 * kMmHg, 6.25e-6};
  double sinusoids = 5 * kMmHg;  // Pa
  double volume = 5e-3;          // of all blood, m^3
};

}  // namespace resect
