// The allowed ranges of a scenario's numbers. They are wide enough for any tissue, organ or
// instrument, and narrow enough to detect a wrong unit. The comment after a range gives its unit; 1
// stands for a number without a unit. docs/scenarios.md, "Ranges", has the same table.
#pragma once

#include "tissue/material.h"

namespace resect {

struct SettingRange {
  double low, high;
  bool holds(double value) const { return value >= low && value <= high; }  // false for NaN
};

namespace ranges {

// Tissue. Young's modulus: fat 1 kPa, liver 5 kPa, cartilage 10 MPa, tendon 1 GPa. Density: lung
// 200 kg/m^3, bone 2000 kg/m^3.
inline constexpr SettingRange kYoung{10, 1e9};               // Pa
inline constexpr SettingRange kPoisson{0, 0.4999};           // 1
inline constexpr SettingRange kDensity{100, 5000};           // kg/m^3
inline constexpr SettingRange kTearEnergy{0.1, 1e6};         // J/m^2; liver 164, rubber 1e4
inline constexpr SettingRange kTearStretch{1, 100};          // 1; outdated: tear energy replaces it
inline constexpr SettingRange kCapsule{0, 1e5};              // N/m
inline constexpr SettingRange kCapsuleStrength{1, 1e6};      // N/m
inline constexpr SettingRange kCapsuleTension{0, 1e4};       // N/m
inline constexpr SettingRange kCutEnergy{0, 1e6};            // J/m^2
inline constexpr SettingRange kCapsuleCutEnergy{0, 1e4};     // J/m
inline constexpr SettingRange kStiffening{0, 20};            // 1
inline constexpr SettingRange kRelaxationShare{0, 10};       // 1
inline constexpr SettingRange kRelaxationTime{0.005, 1000};  // s; substeps resolve no shorter time
inline constexpr double kFastestWave = 5000;        // m/s, of pressure waves; liver 1600, bone 4000
inline constexpr SettingRange kGravity{-100, 100};  // m/s^2
inline constexpr SettingRange kDrag{0, 1000};       // 1/s
inline constexpr SettingRange kDamping{0, 0.5};     // 1
inline constexpr SettingRange kSpringStiffness{0,
                                               1e6};  // N/m, of a ligament or a joint; a knee: 2e5

// Organs.
inline constexpr SettingRange kUnit{1e-9, 1000};     // m: a file's unit of length; nm to km
inline constexpr SettingRange kSpacing{1e-5, 0.1};   // m
inline constexpr SettingRange kJointReach{1e-5, 1};  // m

// Time and place.
inline constexpr SettingRange kFrameRate{1, 1000};    // 1/s
inline constexpr SettingRange kDuration{1e-3, 3600};  // s
inline constexpr SettingRange kKeyTime{0, 3600};      // s
inline constexpr double kFarthestPose = 100;          // m from the origin, along each axis
inline constexpr double kFarthestToolPoint = 10;      // m, in an instrument's own frame
inline constexpr SettingRange kBreathDepth{0, 0.06};  // m; at rest 0.01 to 0.025
inline constexpr SettingRange kBreathRate{1, 60};     // 1/min; at rest 12 to 20
inline constexpr SettingRange kBed{0, 1};             // 1; see Breathing::bed
inline constexpr double kUsualDepth = 0.01;           // m, of a breath at rest
inline constexpr SettingRange kFriction{0, 10};       // 1
inline constexpr SettingRange kBluntness{0, 100};     // 1
inline constexpr SettingRange kSlipForce{0, 1e4};     // N
inline constexpr SettingRange kContactRadius{0, 1};   // m
inline constexpr SettingRange kJawOpening{0, 3};      // rad

}  // namespace ranges

// Throws a usage Error if a value of the material is out of its range. The error names the value,
// its range and the unit.
void requireSound(const TissueMaterial& material);

}  // namespace resect
