// A block of tissue with a vein, for tests of what bleeds.
#pragma once

#include "anatomy/small_vessels.h"
#include "simulation/simulation.h"
#include "support/block_organ.h"
#include "support/test_tools.h"

namespace resect::test {

inline const Vec3 kCut(0.0321, 0.0151, 0.0301);  // where the vein is cut

// A block of 60 x 30 x 60 mm of still tissue with a portal vein of 4 mm along x, and an instrument
// far away.
inline Anatomy portalVeinAlongX() {
  return straightVessel(VesselKind::PortalVein, Vec3(-0.02, kCut.y(), kCut.z()),
                        Vec3(0.05, kCut.y(), kCut.z()), 0.002);
}
inline std::unique_ptr<Tool> thinForceps() {
  return boxTool({{-0.001, -0.001, 0}, {0.001, 0.001, 0.06}}, "bipolar", "");
}
inline Simulation bleedingBlock(const Anatomy& anatomy = portalVeinAlongX(),
                                std::unique_ptr<Tool> tool = thinForceps()) {
  Discretization cells = fullBlock({12, 6, 12});
  cells.lattice.origin = Vec3::Constant(0.0025);
  Organ organ = makeOrgan(std::move(cells), {});
  organ.map = makeVesselMap(anatomy);
  std::vector<std::unique_ptr<Tool>> tools;
  tools.push_back(std::move(tool));
  return Simulation(std::move(organ), std::move(tools));
}

inline StepReport step(Simulation& simulation, std::vector<TissueEdit> edits = {}) {
  FrameInput input;
  input.tools = {{{Vec3(1, 1, 1), Eigen::Quaterniond::Identity()}, true}};
  input.edits = std::move(edits);
  return simulation.step(input);
}

}  // namespace resect::test
