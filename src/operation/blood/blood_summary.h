// What bled in an operation, for people and programs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "simulation/simulation.h"

namespace resect {

// A vessel that was cut.
struct CutVesselSummary {
  VesselKind kind = VesselKind::PortalVein;
  std::string name;           // for people, such as "right portal vein"
  double diameter = 0;        // of the lumen, m
  bool severed = false;       // false: a hole in its wall
  bool closed = false;        // each of its ends is clipped or sealed
  double bled = 0;            // m^3
  double flow = 0;            // in the last frame, m^3/s
  Vec3 place = Vec3::Zero();  // of its end towards the root, world, m
};

// A vessel that runs bare, without tissue round it.
struct BareVesselSummary {
  VesselKind kind = VesselKind::PortalVein;
  std::string name;           // for people
  double diameter = 0;        // of the lumen, m
  Vec3 place = Vec3::Zero();  // middle of its bare part, world, m
  Vec3 along = Vec3::Zero();  // unit, away from the root
  double length = 0;          // of its bare part, m
  bool divided = false;
  int closures = 0;  // clips on it, and places that heat has sealed
};

struct BloodSummary {
  BloodLedger ledger;
  double rate = 0;                        // at the end, mean over a second, m^3/s
  double highest = 0;                     // highest mean over a second, m^3/s
  double air = 0;                         // drawn into hepatic veins, m^3
  std::vector<CutVesselSummary> vessels;  // the widest first
  std::vector<BareVesselSummary> bare;    // the widest first
  double inflowClamped = 0;               // for how long, s
};

// Follows the blood of an operation, frame by frame.
class BloodBooks {
 public:
  void add(const StepReport& report, double duration);
  // Nothing if no organ has vessels.
  std::optional<BloodSummary> summaryOf(const Simulation& simulation) const;

 private:
  double rate_ = 0, highest_ = 0, air_ = 0;
};

// The vessels that were cut, the widest first.
std::vector<CutVesselSummary> cutVessels(const OperatedOrgan& organ);
// The vessels that run bare, the widest first.
std::vector<BareVesselSummary> bareVesselsOf(const OperatedOrgan& organ);

}  // namespace resect
