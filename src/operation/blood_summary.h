// What bled in an operation, for people and programs.
#pragma once

#include <optional>
#include <vector>

#include "simulation/simulation.h"

namespace resect {

// A vessel that was cut.
struct CutVesselSummary {
  VesselKind kind = VesselKind::PortalVein;
  double diameter = 0;   // of the lumen, m
  bool severed = false;  // false: a hole in its wall
  bool closed = false;   // each of its ends is clipped or sealed
  double bled = 0;       // m^3
};

struct BloodSummary {
  BloodLedger ledger;
  double rate = 0;                        // at the end, mean over a second, m^3/s
  double highest = 0;                     // highest mean over a second, m^3/s
  double air = 0;                         // drawn into hepatic veins, m^3
  std::vector<CutVesselSummary> vessels;  // the widest first
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
std::vector<CutVesselSummary> cutVessels(const Organ& organ);

}  // namespace resect
