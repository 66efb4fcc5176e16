// Pressure and flow in vessels with injuries.
//
// Each kind of vessel forms trees of segments. The root of a tree is connected to a source outside
// the organ (blood/flow/circulation.h). The resistance of a vessel follows Poiseuille's law. At an
// open end there is a further loss of pressure by the kinetic energy of the jet: dp = 1.56 rho |Q|
// Q / (2 A^2), with the density rho of blood, the flow Q and the open area A. The leaves of a tree
// (its last segments) end in the liver's capillaries, the sinusoids. In each connected part of the
// tissue, all sinusoids have one common pressure. At this pressure, the flow into the part's
// sinusoids equals the flow out of them. If no vessel connects a part to a source any more, nothing
// flows in the part.
//
// A cut, a clip or a clamp can separate branches of the portal vein or of the artery from their
// source. Blood can then flow back from the sinusoids into these branches, and the sinusoids
// collapse. So the leaves of these branches have a fifth of their normal conductance (an estimate).
//
// Each subtree without injuries is reduced in advance to one conductance between its parent segment
// and the sinusoids. So in a frame, the equations are solved only for the injured segments and for
// the segments between them and the root. (A segment with a clip counts like an injured segment. So
// does a segment whose branches lead to different parts of the tissue.)
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "anatomy/vessel_map.h"
#include "anatomy/vessel_state.h"
#include "blood/flow/circulation.h"

namespace resect {

// Conditions outside the two ends of an injured vessel (index: VesselEnd).
struct EndOutside {
  double pressure[2] = {0, 0};      // just outside the end, relative to the atmosphere, Pa
  bool closed[2] = {false, false};  // true: nothing can flow out, for example inside tissue
};

class VesselFlow {
 public:
  VesselFlow() = default;
  VesselFlow(std::shared_ptr<const VesselMap> map, const Circulation& circulation);

  // Computes the flows out of all open ends and writes them to state.injuries. A negative flow is
  // air that is drawn in. This happens only at wide hepatic veins, and only as fast as blood in the
  // vein makes room for the air. outside: one entry per injury. sources: the present pressures of
  // the sources. sinusoids: the pressures in the sinusoids, Pa, one for each part of the tissue
  // (SegmentPart), the body first. The caller passes the pressures from the last call, and solve()
  // updates them.
  //
  // The pressure loss at an end depends on the flow. So each call does four iterations, which start
  // from the flows of the last call. After a change, the flow is steady only after several calls.
  // Returns the flow of air into open hepatic veins, m^3/s.
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
    // Per segment: conductance from the segment's start to the sinusoids. seen[0]: with the normal
    // conductance of the leaves. seen[1]: with a fifth of it in the portal vein and in the artery,
    // for branches that are separated from their source.
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

  // Used by solve(). Per injury and VesselEnd: whether the end is closed because the pressure
  // outside is higher than the pressure inside.
  mutable std::vector<std::array<bool, 2>> collapsed_;
  std::shared_ptr<const VesselMap> map_;
  const Anatomy* anatomy_ = nullptr;  // the anatomy of map_
  std::array<Tree, kVesselKinds> trees_;
};

}  // namespace resect
