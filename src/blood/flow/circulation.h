// Pressures and resistances of the blood supply of a liver, and properties of blood.
#pragma once

namespace resect {

inline constexpr double kMmHg = 133.322;           // Pa
inline constexpr double kBloodDensity = 1060;      // kg/m^3
inline constexpr double kBloodViscosity = 3.5e-3;  // Pa s
inline constexpr double kEarth = 9.81;             // gravity, m/s^2

// The largest loss of blood that the body can compensate by itself, as a fraction of all blood.
// Larger losses are haemorrhages of the classes II to IV (American College of Surgeons, ATLS 2018).
inline constexpr double kBorneLoss = 0.15;
// Volumes of air in the heart, m^3. More than kBorneAir hinders the heart (estimate). kDeadlyAir
// kills an adult if it enters all at once (200 to 300 ml: Mirski et al. 2007,
// doi:10.1097/00000542-200701000-00026).
inline constexpr double kBorneAir = 50e-6, kDeadlyAir = 300e-6;

// How one kind of vessel is connected to the rest of the body. The source is the place outside the
// organ to which these vessels lead. For the hepatic veins it is the vena cava. The flow is that
// into an organ without injuries. For the hepatic veins the flow is negative, since their blood
// leaves the organ.
struct Supply {
  double pressure = 0;    // of the source, Pa
  double resistance = 0;  // between the source and the root of the vessel tree, Pa s/m^3
  double flow = 0;        // into the organ, m^3/s
};

// The present pressure of each source, divided by Supply::pressure.
struct SourceShares {
  double artery = 1, portal = 1, vein = 1;
};

// Values before any bleeding. Blood flows through the organ at 1.5 l/min: a quarter comes from the
// artery, three quarters come from the portal vein. The pressures are 8 mmHg in the portal vein, 90
// mmHg at the source of the portal vein, 3 mmHg in the vena cava, and 5 mmHg in the sinusoids,
// which are the liver's capillaries (docs/methods/blood.md).
struct Circulation {
  Supply portal{90 * kMmHg, 4.37e6 * kMmHg, 18.75e-6};
  Supply hepatic{3 * kMmHg, 0.02e6 * kMmHg, -25e-6};
  Supply artery{95 * kMmHg, 0.8e6 * kMmHg, 6.25e-6};
  double sinusoids = 5 * kMmHg;  // Pa
  double volume = 5e-3;          // volume of all blood of the body, m^3
};

}  // namespace resect
