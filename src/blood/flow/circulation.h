// Pressures at which a liver is supplied with blood, and what blood is like.
#pragma once

namespace resect {

inline constexpr double kMmHg = 133.322;           // Pa
inline constexpr double kBloodDensity = 1060;      // kg/m^3
inline constexpr double kBloodViscosity = 3.5e-3;  // Pa s
inline constexpr double kEarth = 9.81;             // m/s^2

// The supply of one kind of vessel: a source at constant pressure behind a resistance, and the flow
// through an organ without injuries. Out of the hepatic veins the flow is negative.
struct Supply {
  double pressure = 0;    // of the source, Pa
  double resistance = 0;  // between the source and the root of the tree, Pa s/m^3
  double flow = 0;        // into the organ, m^3/s
};

// Pressures of the sources over those at rest.
struct SourceShares {
  double artery = 1, portal = 1, vein = 1;
};

// Values at rest: a quarter of the flow is arterial, three quarters portal, 1.5 l/min in all; 8
// mmHg in the portal vein, 3 in the vena cava, 5 in the sinusoids (docs/methods/blood.md).
struct Circulation {
  Supply portal{90 * kMmHg, 4.37e6 * kMmHg, 18.75e-6};
  Supply hepatic{3 * kMmHg, 0.02e6 * kMmHg, -25e-6};
  Supply artery{95 * kMmHg, 0.8e6 * kMmHg, 6.25e-6};
  double sinusoids = 5 * kMmHg;  // Pa
  double volume = 5e-3;          // of all blood, m^3
};

}  // namespace resect
