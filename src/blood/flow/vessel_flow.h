// Pressure and flow in injured vessels.
//
// A vessel resists by Poiseuille's law. An open end resists besides by the energy that leaves with
// the jet: dp = 1.56 rho |Q| Q / (2 A^2). All leaves in a connected part of the tissue end in
// sinusoids of one pressure, which is such that what flows in flows out. Nothing flows in a part to
// which no vessel leads any more. Where blood runs backwards out of the sinusoids, these collapse:
// a leaf of a portal branch or artery then carries a fifth (an estimate).
//
// The part of a tree without injuries is condensed once: seen from its parent, it is a conductance
// to the sinusoids. So the cost of a frame is that of the injured segments and those between them
// and the root, not that of the tree.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "anatomy/vessel_map.h"
#include "anatomy/vessel_state.h"
#include "blood/flow/circulation.h"

namespace resect {

// The open ends of an injury: how hard it is to flow out.
struct EndOutside {
  double pressure[2] = {0, 0};      // beyond the end, Pa, over the atmosphere
  bool closed[2] = {false, false};  // pressed shut, or inside tissue
};

class VesselFlow {
 public:
  VesselFlow() = default;
  VesselFlow(std::shared_ptr<const VesselMap> map, const Circulation& circulation);

  // Solves for the flows out of all open ends, and writes them to state.injuries: never below 0.
  // outside: one per injury. sources: their pressures over those at rest. sinusoids: the pressures
  // in them after the last call, Pa, by part (SegmentPart), the body first; updated. The loss at
  // the ends grows with the flow, so a call makes some rounds from the flows of the last one; after
  // a change some calls are needed until the flow is steady. Returns the flow of air into open
  // hepatic veins, m^3/s.
  double solve(VesselState& state, std::span<const EndOutside> outside, const SourceShares& sources,
               std::vector<double>& sinusoids) const;

  // Flow into the organ through the root of a kind after the last solve(), m^3/s.
  double inflow(VesselKind kind) const { return trees_[std::size_t(kind)].inflow; }
  // Resistance of a leaf of the kind, Pa s/m^3.
  double leafResistance(VesselKind kind) const {
    return 1 / trees_[std::size_t(kind)].leafConductance;
  }
  bool empty() const { return !anatomy_; }

 private:
  struct Tree {
    VesselRange range;
    Supply supply;
    double leafConductance = 0;
    std::vector<std::int32_t> firstChild, children, roots;  // indices within the tree
    std::vector<double> resistance;                         // per segment
    // Per segment, seen from its start: conductance to the sinusoids, forwards and backwards.
    std::array<std::vector<double>, 2> seen;
    mutable double inflow = 0;
  };
  struct Part;

  void condense(Tree& tree) const;
  double conductance(Tree& tree, double leaf) const;
  Part concernedPart(const Tree& tree, const VesselState& state, std::vector<bool>& fed) const;
  void solveTree(const Tree& tree, Part& part, VesselState& state,
                 std::span<const EndOutside> outside, double source,
                 std::span<const double> sinusoids, bool keep, std::span<double> into,
                 double& air) const;

  // Work of solve(): per injury, the ends into which the outside would press blood.
  mutable std::vector<std::array<bool, 2>> collapsed_;
  std::shared_ptr<const VesselMap> map_;
  const Anatomy* anatomy_ = nullptr;  // of map_
  std::array<Tree, kVesselKinds> trees_;
};

}  // namespace resect
