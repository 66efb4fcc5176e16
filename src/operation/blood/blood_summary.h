// Summary of the bleeding in an operation, for people and programs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "simulation/simulation.h"

namespace resect {

// A vessel that was cut.
struct CutVesselSummary {
  VesselKind kind = VesselKind::PortalVein;
  std::string name;      // for people, such as "right portal vein"
  double diameter = 0;   // of the lumen, m
  bool severed = false;  // false: the vessel has a hole in its wall
  // Whether clips or heat close the vessel. A severed vessel must be closed at both ends. Any other
  // vessel must be closed between the hole and the root of its tree.
  bool closed = false;
  double bled = 0;            // blood lost so far, m^3
  double flow = 0;            // flow of blood out of the vessel in the last frame, m^3/s
  Vec3 place = Vec3::Zero();  // present position of that end of the injury which is nearer to the
                              // root of the tree, world, m
};

// A bare vessel: one without tissue round it.
struct BareVesselSummary {
  VesselKind kind = VesselKind::PortalVein;
  std::string name;           // for people
  double diameter = 0;        // of the lumen, m
  Vec3 place = Vec3::Zero();  // middle of the vessel's bare part, world, m
  Vec3 along = Vec3::Zero();  // direction away from the root, unit
  double length = 0;          // of its bare part, m
  bool divided = false;
  int closures = 0;  // number of clips and of heat seals on the vessel
};

struct BloodSummary {
  BloodLedger ledger;
  double rate = 0;                        // blood loss per time, mean over about 1 s, m^3/s
  double highest = 0;                     // highest value of `rate` so far, m^3/s
  double air = 0;                         // air drawn into hepatic veins, m^3
  std::vector<CutVesselSummary> vessels;  // the widest first
  std::vector<BareVesselSummary> bare;    // the widest first
  int clips = 0, sealed = 0;  // numbers of clips on vessels, and of segments that heat closes
  double inflowClamped = 0;   // time for which the inflow of blood into the liver was clamped, s
};

// Follows the blood of an operation, frame by frame.
class BloodBooks {
 public:
  // To be called after each step. duration: of the frame, s.
  void add(const StepReport& report, double duration);
  // The summary up to now; nothing if no organ has vessels.
  std::optional<BloodSummary> summaryOf(const Simulation& simulation) const;

 private:
  double rate_ = 0, highest_ = 0;
};

// The vessels that were cut, the widest first.
std::vector<CutVesselSummary> cutVessels(const OperatedOrgan& organ);
// The bare vessels, the widest first.
std::vector<BareVesselSummary> bareVesselsOf(const OperatedOrgan& organ);

}  // namespace resect
