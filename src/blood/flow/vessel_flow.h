// Pressure and flow in vessels with injuries.
//
// The resistance of a vessel follows Poiseuille's law. At an open end the kinetic energy of the jet
// costs a further pressure, dp = 1.56 rho |Q| Q / (2 A^2), with the flow Q and the open area A. All
// leaves in one connected part of the tissue end in sinusoids at one common pressure. At this
// pressure as much blood flows into these sinusoids as out of them. In a part to which no vessel
// leads any more, nothing flows. If blood flows from the sinusoids back into branches of the portal
// vein or artery, the sinusoids collapse: the leaves of these branches then have a fifth of their
// conductance (an estimate).
//
// Each subtree without injuries is reduced in advance to one conductance between its parent and the
// sinusoids. So the cost of a frame is that of the injured segments and of those between them and
// the root, and not that of the whole tree.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "anatomy/vessel_map.h"
#include "anatomy/vessel_state.h"
#include "blood/flow/circulation.h"

namespace resect {

// Conditions outside the two ends of an injury (index: VesselEnd).
struct EndOutside {
  double pressure[2] = {0, 0};      // just outside the end, relative to the atmosphere, Pa
  bool closed[2] = {false, false};  // nothing can flow out, as inside tissue
};

class VesselFlow {
 public:
  VesselFlow() = default;
  VesselFlow(std::shared_ptr<const VesselMap> map, const Circulation& circulation);

  // Computes the flows out of all open ends and writes them to state.injuries; a flow is never
  // below 0. outside: one entry per injury. sources: the present pressures of the sources, divided
  // by their values at rest. sinusoids: the pressures in the sinusoids, Pa, one per part of the
  // tissue (SegmentPart), the body first; the caller passes the pressures that the last call gave,
  // and solve() updates them. The pressure loss at an end depends on the flow, so each call does
  // four iterations that start from the last flows; after a change it takes several calls until the
  // flow is steady. Returns the flow of air into open hepatic veins, m^3/s.
  double solve(VesselState& state, std::span<const EndOutside> outside, const SourceShares& sources,
               std::vector<double>& sinusoids) const;

  // Flow into the organ through the root of the tree of this kind, as of the last solve(), m^3/s.
  double inflow(VesselKind kind) const { return trees_[std::size_t(kind)].inflow; }
  // Resistance of a leaf of this kind to the sinusoids, Pa s/m^3.
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
    std::vector<double> resistance;                         // of each segment, Pa s/m^3
    // Per segment: the conductance from its start to the sinusoids, [0] forwards, [1] backwards.
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

  // Used by solve(): per injury and VesselEnd, whether the end is closed because the pressure
  // outside is higher than inside.
  mutable std::vector<std::array<bool, 2>> collapsed_;
  std::shared_ptr<const VesselMap> map_;
  const Anatomy* anatomy_ = nullptr;  // of map_
  std::array<Tree, kVesselKinds> trees_;
};

}  // namespace resect
