// Blood under long random work.
//
// Four instruments work on a liver with vessels at random, cells are removed, bonds severed,
// vessels divided, clipped, pressed on, sealed and sucked dry. RESECT_WORK_SECONDS: how long, in
// simulated seconds (8); RESECT_WORK_SEED.
#include <doctest/doctest.h>

#include "anatomy/growth/vessel_growth.h"
#include "organ/discretize.h"
#include "simulation/random_hands.h"
#include "simulation/simulation.h"
#include "support/blades.h"
#include "support/environment.h"
#include "support/same_at_any_threads.h"
#include "tissue/elastic/elastic_tissue.h"

using namespace resect;

namespace {

constexpr double kLiverSpacing = 0.010;  // m

// Edits of a frame. What lasts, such as suction, is done for a while where something bleeds.
class RandomEdits {
 public:
  RandomEdits(Random& random, const Simulation& simulation)
      : random_(random), simulation_(simulation) {}

  std::vector<TissueEdit> next(const BloodReport& blood) {
    std::vector<TissueEdit> edits;
    const auto add = [&](auto edit) { edits.push_back({0, -1, edit}); };
    const Lattice& lattice = simulation_.organ().rest.lattice;
    const std::int64_t cell = random_.below(int(lattice.cellCount()));
    const std::int32_t segment =
        random_.below(int(simulation_.organ().map->anatomy.segments.size()));
    const int what = random_.below(400);
    if (what < 12) add(RemoveCell{cell});
    if (what >= 12 && what < 16) {
      const Vec3 from = lattice.centre(lattice.cell(cell));
      const double along = random_.uniform(-0.01, 0.01);
      add(Carve{{from, from + Vec3(along, 0.003, -along), random_.uniform(0.002, 0.008)}});
    }
    if (what == 16) add(SeverBond{cell, random_.below(26)});
    if (what == 17) add(Incision{blade(lattice.centre(lattice.cell(cell)))});
    if (what == 18) add(DivideVessel{segment, random_.uniform()});
    if (what == 19) add(PlaceClip{segment, random_.uniform()});
    if (what == 20) add(ClampInflow{clamped_ = !clamped_});
    if (left_-- <= 0) {
      left_ = 120;
      doing_ = random_.below(8);  // from 4: nothing
      world_ = Vec3::Zero();
      if (!blood.ends.empty()) {
        const BleedingEnd& end = blood.ends[std::size_t(random_.below(int(blood.ends.size())))];
        world_ = end.place;
        const VesselSegment& s =
            simulation_.organ().map->anatomy.segments[std::size_t(end.segment)];
        rest_ = s.at(0.5);
      }
    }
    if (doing_ == 0) add(Suction{world_, 0.015, 25e-6});
    if (doing_ == 1) add(Press{world_, 0.02, 4000, 4e-6});
    if (doing_ == 2) add(Heat{rest_, 0.005, 60});
    if (doing_ == 3 && left_ % 20 == 0 && !blood.ends.empty()) {
      const BleedingEnd& end = blood.ends[std::size_t(left_ / 20) % blood.ends.size()];
      add(PlaceClip{end.segment, end.end == VesselEnd::Root ? 0.01 : 0.99});
    }
    return edits;
  }

 private:
  // 3 x 3 cm across a random direction.
  SweptBlade blade(const Vec3& middle) {
    const Vec3 normal =
        Vec3(random_.uniform(-1, 1), random_.uniform(-1, 1), random_.uniform(-1, 1)).normalized();
    const Vec3 along = normal.unitOrthogonal();
    return test::flatBlade(middle, 0.015 * along, 0.015 * normal.cross(along));
  }

  Random& random_;
  const Simulation& simulation_;
  bool clamped_ = false;
  int left_ = 0, doing_ = 0;
  Vec3 world_ = Vec3::Zero(), rest_ = Vec3::Zero();
};

std::uint64_t work(double seconds, int threads) {
  Random random(std::uint64_t(test::numberFrom("RESECT_WORK_SEED", 1)));
  const test::LyingLiver liver = test::lyingLiver();
  VesselGrowth growth = builtinLiverVessels();
  growth.terminals = 200;
  Discretization cells =
      discretize(liver.mesh, latticeForSpacing(bounds(liver.mesh), kLiverSpacing));
  auto tissue = std::make_unique<ElasticTissue>(
      TissueCells{cells.lattice, cells.inside, {liverTissue()}, {}}, TissueSettings{});
  Organ organ = makeOrgan(std::move(cells), {});
  organ.map = makeVesselMap(transformed(growVessels(builtinLiver(0.004), growth), liver.pose));
  Simulation simulation(std::move(organ), test::instruments(), std::move(tissue));
  test::RandomHands hands(random, int(simulation.tools().size()), bounds(liver.mesh));
  RandomEdits edits(random, simulation);

  StepReport report;
  std::int64_t removed = 0, severed = 0, torn = 0;
  std::size_t mostEnds = 0, mostWet = 0;
  const std::int64_t frames = std::int64_t(60 * seconds);
  for (std::int64_t frame = 0; frame < frames; ++frame) {
    FrameInput input = hands.next(simulation.time(), frame > 30);
    input.edits = edits.next(report.blood);
    report = simulation.step(input);
    const BloodLedger& l = report.blood.ledger;
    REQUIRE(l.bled == l.found());
    REQUIRE(std::min({l.bled, l.film, l.clotted, l.drops, l.pools, l.sucked, l.absorbed, l.lost}) >=
            0);
    removed += report.removed, severed += report.severed, torn += report.torn;
    mostEnds = std::max(mostEnds, report.blood.ends.size());
    mostWet = std::max(mostWet, simulation.blood().film(0).wet().size());
    if (frame == frames - 1 || frame % 3600 == 3599)
      MESSAGE(threads << " threads, " << simulation.time() << " s: " << hands.acts() << " acts, "
                      << removed << " cells removed, " << severed << " bonds cut, " << torn
                      << " torn, at most " << mostEnds << " ends bled and " << mostWet
                      << " cells were wet; bled " << 1e6 * toCubicMetres(l.bled) << " ml; "
                      << 1e-6 * double(simulation.bytes()) << " MB; state "
                      << simulation.stateHash());
  }
  CHECK(hands.acts() > 1);
  CHECK(report.blood.ledger.bled > toPicolitres(1e-6));
  return simulation.stateHash();
}

}  // namespace

TEST_CASE("random work on a liver that bleeds: the ledger is exact, at 1 and 2 threads alike") {
  const double seconds = test::numberFrom("RESECT_WORK_SECONDS", 8);
  std::uint64_t hash[2];
  for (const int threads : {1, 2}) {
    const ThreadLimit limit(threads);
    hash[threads - 1] = work(seconds, threads);
  }
  CHECK(hash[0] == hash[1]);
}
