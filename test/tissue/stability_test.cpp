// The substep is stable for all deformations tested.
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "geometry/measures.h"
#include "organ/builtin/builtin_liver.h"
#include "organ/discretize.h"
#include "organ/tissue_cells.h"
#include "support/figures.h"
#include "support/frequency.h"
#include "support/tissue_blocks.h"

using namespace resect;

namespace {

// Some 1 100 cells with the thin margins and ragged edges of an organ.
TissueCells liver() {
  const TriangleMesh mesh = builtinLiver(0.005);
  const Discretization cells = discretize(mesh, latticeForSpacing(bounds(mesh), 0.0115));
  return tissueCells(cells, liverTissue());
}

}  // namespace

TEST_CASE("the substep is stable at rest, stretched, sheared, swollen and pressed flat") {
  test::Figures figures("stability");
  TissueSettings settings = test::weightless();
  Mat3 shear = Mat3::Identity();
  shear(0, 1) = 1;
  const double side = std::sqrt(0.5);
  const std::pair<const char*, Mat3> states[] = {
      {"at rest", Mat3::Identity()},
      {"stretched to 1.3", Vec3(1.3, 1, 1).asDiagonal()},
      {"stretched to 2, volume kept", Vec3(2, side, side).asDiagonal()},
      {"stretched to 1.5 both ways", Vec3(1.5, 1.5, 1).asDiagonal()},
      {"stretched to 1.9 both ways, volume kept", Vec3(1.9, 1.9, 0.277).asDiagonal()},
      {"swollen to 1.4", 1.4 * Mat3::Identity()},
      {"pressed to a fifth", Vec3(1, 0.2, 1).asDiagonal()},
      {"sheared by 1", shear}};
  // Of v += dt a(u + beta dt v), u += dt v: stable while (omega dt)^2 (1 + 2 beta) < 4.
  const double limit = 2 / std::sqrt(1 + 2 * settings.damping);
  for (const auto& [name, f] : states) {
    ElasticTissue tissue(liver(), settings);
    std::vector<std::int64_t> cells;
    test::forEachSolid(tissue, [&](std::int64_t c, const Vec3i&) { cells.push_back(c); });
    REQUIRE(cells.size() > 800);
    std::vector<Vec3> u;
    for (const std::int64_t c : cells) {
      u.push_back((f - Mat3::Identity()) * tissue.lattice().centre(tissue.lattice().cell(c)));
      tissue.setDisplacement(c, u.back());
      tissue.hold(c, kHeldAll);
    }
    // At once, before branches have relaxed; and after a while, with the substep that stiff cells
    // have called for. Nothing is stretched to 1.9 both ways within a frame.
    double share = 0;
    for (const int frames : {0, 5}) {
      if (frames == 0 && f == states[4].second) continue;
      for (int i = 0; i < frames; ++i) tissue.advance(1.0 / 60);
      share = std::max(share,
                       test::highestFrequency(tissue, cells, u) * tissue.presentSubstep() / limit);
    }
    CHECK(share > 0.3);  // no longer substep is given away than needed
    CHECK(figures.addError("substep / longest stable, " + std::string(name), share, 1) < 1);
  }
}
