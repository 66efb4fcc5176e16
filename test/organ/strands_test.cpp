// Strands of surface are found as by a plain search: every node of the grid asked, every search
// from the beginning.
#include "organ/incision/strands.h"

#include <doctest/doctest.h>

#include <deque>
#include <map>

#include "base/index_box.h"
#include "organ/incision/node_owners.h"
#include "support/blades.h"
#include "support/block_organ.h"
#include "tissue/elastic/elastic_tissue.h"
#include "tissue/stencil.h"

using namespace resect;

namespace {

using Place = std::array<int, 3>;
Place placeOf(const Vec3i& n) { return {n.x(), n.y(), n.z()}; }

bool inTissue(const Organ& organ, const Vec3i& n) {
  return organ.field.node(n) >= organ.surface.iso();
}
bool whole(const Organ& organ, const Vec3i& lower, int axis) {
  return inTissue(organ, lower) && inTissue(organ, lower + Vec3i::Unit(axis)) &&
         organ.severed.at(lower, axis) == kWhole;
}

// The first of the particles that are fewest whole edges away.
class PlainOwners {
 public:
  explicit PlainOwners(const Organ& organ) : organ_(organ) {
    const Lattice& lattice = organ.rest.lattice;
    for (std::int64_t c = 0; c < lattice.cellCount(); ++c)
      if (organ.alive[std::size_t(c)] && organ.rest.inside[std::size_t(c)])
        particle_[placeOf(organ.field.refine() * (lattice.cell(c) + Vec3i::Constant(2)))] = c;
  }
  std::int64_t operator()(const Vec3i& node) const {
    std::map<Place, int> edges = {{placeOf(node), 0}};
    std::deque<Vec3i> queue = {node};
    std::int64_t owner = -1;
    int at = NodeOwners::kFar;
    for (; !queue.empty(); queue.pop_front()) {
      const Vec3i n = queue.front();
      const int distance = edges.at(placeOf(n));
      if (distance > at) break;
      if (const auto p = particle_.find(placeOf(n)); p != particle_.end()) {
        owner = owner < 0 ? p->second : std::min(owner, p->second);
        at = distance;
      }
      if (distance == NodeOwners::kFar) continue;
      for (int axis = 0; axis < 3; ++axis)
        for (const int step : {-1, 1}) {
          const Vec3i next = n + step * Vec3i::Unit(axis);
          if (whole(organ_, step < 0 ? next : n, axis) &&
              edges.try_emplace(placeOf(next), distance + 1).second)
            queue.push_back(next);
        }
    }
    return owner;
  }

 private:
  const Organ& organ_;
  std::map<Place, std::int64_t> particle_;
};

bool held(const Lattice& lattice, const TissueModel& tissue, std::int64_t p, std::int64_t q) {
  for (std::int64_t third = 0; third < lattice.cellCount(); ++third) {
    const auto bonded = [&](std::int64_t a, std::int64_t b) {
      if (a == b) return true;
      const Vec3i offset = lattice.cell(b) - lattice.cell(a);
      return offset.cwiseAbs().maxCoeff() <= 1 && (tissue.bonds(a) >> directionTo(offset) & 1);
    };
    if (bonded(p, third) && bonded(third, q)) return true;
  }
  return false;
}

// An organ with two holes and a few cuts, some of which part bonds.
struct CutOrgan {
  Organ organ;
  ElasticTissue tissue;
  std::vector<std::int64_t> particles;
  std::vector<TissueBond> parted;

  CutOrgan(int refine, Random& random)
      : organ(make(refine)), tissue({organ.rest.lattice, organ.alive, {TissueMaterial{}}, {}}, {}) {
    const Lattice& lattice = organ.rest.lattice;
    const Vec3 middle = lattice.box().centre();
    for (int cut = 0; cut < 3; ++cut) incise(organ, test::randomBlade(middle, 0.02, 0.005, random));
    for (std::int64_t c = 0; c < lattice.cellCount(); ++c)
      if (tissue.solid(c)) particles.push_back(c);
    const Vec3 normal(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    const auto above = [&](std::int64_t c) {
      return (lattice.centre(lattice.cell(c)) - middle).dot(normal) > 0;
    };
    for (const std::int64_t c : particles)
      for (int d = kFirstForward; d < kDirections; ++d)
        if (tissue.bonds(c) >> d & 1) {
          const std::int64_t other = lattice.index(lattice.cell(c) + offsetOf(d));
          if (above(c) == above(other)) continue;
          tissue.sever(c, d);
          if (random.uniform() < 0.3) parted.push_back({c, d});
        }
  }
  static Organ make(int refine) {
    OrganSettings settings;
    settings.refine = refine;
    Organ organ = makeOrgan(test::ball(9), settings);
    for (const Vec3i& hole : {Vec3i(4, 5, 4), Vec3i(5, 5, 4), Vec3i(6, 4, 6)})
      removeParticle(organ, organ.rest.lattice.index(hole));
    updateSurface(organ, updateField(organ));
    return organ;
  }
};

}  // namespace

TEST_CASE("a node goes with the particle that a plain search finds") {
  Random random(31);
  for (const int refine : {1, 2, 3}) {
    const CutOrgan cut(refine, random);
    const IndexBox box{Vec3i::Zero(), cut.organ.field.nodeDims()};
    TissueGrid grid(cut.organ, box.widened(NodeOwners::kFar));
    NodeOwners ownerOf(cut.organ, grid, box);
    const PlainOwners plain(cut.organ);
    int asked = 0, wrong = 0;
    for (std::int32_t i = 0; i < std::int32_t(box.count()); ++i) {
      const Vec3i node = box.coordinates(i);
      if (!inTissue(cut.organ, node)) continue;
      CHECK(grid.inTissue(node));
      wrong += ownerOf(node) != plain(node);
      ++asked;
    }
    CHECK(asked > 100);
    CHECK(wrong == 0);
  }
}

TEST_CASE("strands are severed where a search of all nodes round the particles finds them") {
  Random random(32);
  int strands = 0;
  for (int run = 0; run < 12; ++run) {
    const int refine = 1 + run % 3;
    INFO("run ", run, ", refinement ", refine);
    CutOrgan cut(refine, random);
    const Lattice& lattice = cut.organ.rest.lattice;
    const bool bladeNear = run % 2 == 0;
    // Nodes within a cell of those that may have to part.
    std::map<Place, bool> anywhere;  // or only beside cuts
    const auto add = [&](std::int64_t particle, bool all) {
      const Vec3i centre = refine * (lattice.cell(particle) + Vec3i::Constant(2));
      for (int i = 0; i < (2 * refine + 1) * (2 * refine + 1) * (2 * refine + 1); ++i) {
        const int side = 2 * refine + 1;
        const Vec3i n =
            centre + Vec3i(i % side, i / side % side, i / side / side) - Vec3i::Constant(refine);
        anywhere[placeOf(n)] |= all;
      }
    };
    if (bladeNear)
      for (const std::int64_t p : cut.particles) add(p, false);
    for (const TissueBond& bond : cut.parted) {
      add(bond.cell, true);
      add(lattice.index(lattice.cell(bond.cell) + offsetOf(bond.direction)), true);
    }
    const PlainOwners ownerOf(cut.organ);
    std::map<Place, std::int64_t> owner;
    for (const auto& [place, all] : anywhere) {
      const Vec3i n(place[0], place[1], place[2]);
      if (inTissue(cut.organ, n) &&
          (all || cut.organ.severed.near(cut.organ.field.brickIndex(n / kBrickNodes))))
        owner[place] = ownerOf(n);
    }
    std::vector<std::pair<Vec3i, int>> expected;
    for (const auto& [place, p] : owner)
      for (int axis = 0; axis < 3; ++axis) {
        const Vec3i n(place[0], place[1], place[2]);
        const auto to = owner.find(placeOf(n + Vec3i::Unit(axis)));
        if (to == owner.end() || !whole(cut.organ, n, axis) || p < 0 || to->second < 0) continue;
        if (!held(lattice, cut.tissue, p, to->second)) expected.push_back({n, axis});
      }
    const std::vector<std::int64_t> near = bladeNear ? cut.particles : std::vector<std::int64_t>{};
    CHECK(partStrands(cut.organ, cut.tissue, cut.parted, near) == std::int64_t(expected.size()));
    for (const auto& [n, axis] : expected) CHECK(!whole(cut.organ, n, axis));
    strands += int(expected.size());
  }
  CHECK(strands > 300);
}
