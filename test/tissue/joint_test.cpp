// Joints hold organs together and conserve their total momentum.
#include <doctest/doctest.h>

#include "base/parallel.h"
#include "base/state/state_hash.h"
#include "support/same_at_any_threads.h"
#include "support/tissue_blocks.h"
#include "tissue/move_tissues.h"
#include "tissue/still_tissue.h"

using namespace resect;
using test::kFrame;
using test::material;
using test::solidBlock;
using test::weightless;

namespace {

constexpr double kJointSpacing = 0.008;
const Vec3i kDims(6, 5, 4);

// Two blocks side by side along x, one cell apart; the second may lie elsewhere.
TissueCells cellsAt(const Vec3& origin, double spacing = kJointSpacing, const Vec3i& dims = kDims) {
  TissueCells cells = solidBlock(dims, spacing, material(8000, 0.3));
  cells.lattice.origin = origin;
  return cells;
}
const Vec3 kBeside(6 * kJointSpacing, 0, 0);

// Organs by number with what joins them.
struct Joined {
  std::vector<std::unique_ptr<TissueModel>> tissues;
  std::vector<Lattice> lattices;
  std::vector<TissueJoint> joints;
  std::vector<TissueStep> steps;

  void add(const TissueCells& cells, const TissueSettings& settings) {
    tissues.push_back(std::make_unique<ElasticTissue>(cells, settings));
    lattices.push_back(cells.lattice);
  }
  void addStill(const TissueCells& cells) {
    tissues.push_back(std::make_unique<StillTissue>(cells.lattice, cells.solid));
    lattices.push_back(cells.lattice);
  }
  ElasticTissue& elastic(std::size_t n) { return static_cast<ElasticTissue&>(*tissues[n]); }
  std::vector<JoinedOrgan> organs() const {
    std::vector<JoinedOrgan> organs;
    for (std::size_t n = 0; n < tissues.size(); ++n)
      organs.push_back({std::int32_t(n), &lattices[n], tissues[n].get()});
    return organs;
  }
  void join(double reach, double stiffness) {
    double shortest = 1;
    for (const auto& tissue : tissues)
      if (const auto* elastic = dynamic_cast<const ElasticTissue*>(tissue.get()))
        shortest = std::min(shortest, elastic->longestSubstep());
    const auto all = organs();
    joints = joinNear(all[0], all[1], reach, stiffness, shortest);
    for (const TissueJoint& joint : joints)
      for (std::size_t end = 0; end < 2; ++end)
        tissues[std::size_t(joint.organ[end])]->mayPull(joint.cell[end]);
    steps.resize(tissues.size());
  }
  void move(int frames = 1) {
    for (int i = 0; i < frames; ++i) {
      std::vector<MovingTissue> moving;
      for (std::size_t n = 0; n < tissues.size(); ++n)
        if (tissues[n]->moves()) moving.push_back({tissues[n].get(), {}, &steps[n]});
      moveTissues(moving, joints, organs(), kFrame);
    }
  }
  template <typename Of>
  Vec3 sum(std::size_t n, Of of) const {
    Vec3 sum = Vec3::Zero();
    for (std::int64_t c = 0; c < lattices[n].cellCount(); ++c)
      if (tissues[n]->solid(c)) sum += of(*tissues[n], c);
    return sum;
  }
  Vec3 momentum(std::size_t n) const {
    return sum(
        n, [](const TissueModel& t, std::int64_t c) { return Vec3(t.mass(c) * t.velocity(c)); });
  }
  Vec3 meanDisplacement(std::size_t n) const {
    return sum(n, [](const TissueModel& t, std::int64_t c) { return t.displacement(c); }) /
           double(lattices[n].cellCount());
  }
  std::uint64_t hash() const {
    HashVisitor visitor;
    for (const auto& tissue : tissues) tissue->visit(visitor);
    return visitor.value();
  }
};

Joined pair(const TissueSettings& settings, double stiffness = 400) {
  Joined two;
  two.add(cellsAt(Vec3::Zero()), settings);
  two.add(cellsAt(kBeside), settings);
  two.join(1.01 * kJointSpacing, stiffness);
  return two;
}

}  // namespace

TEST_CASE(
    "cells within reach are joined to the nearest of the other organ, at their rest distance") {
  Joined two = pair(weightless());
  REQUIRE(two.joints.size() == std::size_t(kDims.y() * kDims.z()));
  double stiffness = 0;
  for (const TissueJoint& joint : two.joints) {
    CHECK(joint.organ == std::array<std::int32_t, 2>{0, 1});
    const Vec3i a = two.lattices[0].cell(joint.cell[0]), b = two.lattices[1].cell(joint.cell[1]);
    CHECK(a == Vec3i(5, b.y(), b.z()));
    CHECK(b.x() == 0);
    CHECK((joint.rest - Vec3(kJointSpacing, 0, 0)).norm() < 1e-12);
    CHECK(joint.damping > 0);
    stiffness += joint.stiffness;
  }
  CHECK(stiffness == doctest::Approx(400));
  const auto organs = two.organs();
  const auto found = [&](double reach) {
    return joinNear(organs[0], organs[1], reach, 1, 1e-4).size();
  };
  CHECK(found(0.99 * kJointSpacing) == 0);
  CHECK(found(2.01 * kJointSpacing) == 2 * two.joints.size());
  // What is gone is not joined.
  two.elastic(0).remove(two.joints[0].cell[0]);
  two.elastic(0).settle();
  CHECK(found(1.01 * kJointSpacing) == two.joints.size() - 1);
}

TEST_CASE("of lattices that do not line up the nearest cell is the one found by looking at all") {
  Joined two;
  two.add(cellsAt(Vec3::Zero()), weightless());
  two.add(cellsAt({0.7 * kJointSpacing, 4.6 * kJointSpacing, 0.4 * kJointSpacing},
                  0.6 * kJointSpacing, {9, 7, 8}),
          weightless());
  const auto organs = two.organs();
  for (const double reach : {0.4, 0.8, 1.0, 1.7, 2.5}) {
    const auto joints = joinNear(organs[0], organs[1], reach * kJointSpacing, 1, 1e-4);
    std::size_t joined = 0;
    for (std::int64_t c = 0; c < two.lattices[0].cellCount(); ++c) {
      double nearest = reach * kJointSpacing;
      bool any = false;
      for (std::int64_t o = 0; o < two.lattices[1].cellCount(); ++o) {
        const double d = (two.lattices[1].centre(two.lattices[1].cell(o)) -
                          two.lattices[0].centre(two.lattices[0].cell(c)))
                             .norm();
        any = any || d <= nearest;
        nearest = std::min(nearest, d);
      }
      if (!any) continue;
      REQUIRE(joined < joints.size());
      CHECK(joints[joined].cell[0] == c);
      CHECK(joints[joined].rest.norm() == doctest::Approx(nearest).epsilon(1e-9));
      ++joined;
    }
    CHECK(joined == joints.size());
    CHECK((joined > 0 || reach < 0.5));
  }
}

TEST_CASE("a block that is drawn away takes the one that is joined to it along") {
  for (const bool joined : {true, false}) {
    TissueSettings settings = weightless();
    settings.drag = 4;
    Joined two = pair(settings);
    if (!joined) two.joints.clear();
    const Vec3 speed(-0.05, 0.02, 0.03);
    for (int z = 0; z < kDims.z(); ++z)
      for (int y = 0; y < kDims.y(); ++y)
        two.elastic(0).hold(two.lattices[0].index({0, y, z}), kHeldAll, speed);
    two.move(120);
    const Vec3 drawn = 2 * speed, first = two.meanDisplacement(0), second = two.meanDisplacement(1);
    INFO(first.transpose(), " and ", second.transpose());
    CHECK((first - drawn).norm() < 0.15 * drawn.norm());
    if (joined)
      CHECK((second - drawn).norm() < 0.25 * drawn.norm());
    else
      CHECK(second == Vec3::Zero());
    CHECK(two.steps[0].substeps == two.steps[1].substeps);
  }
}

TEST_CASE("without weight and drag the momenta of joined blocks add up to what they were") {
  Joined two = pair(weightless());
  const Vec3 speed(-0.3, 0.1, -0.2);
  for (std::int64_t c = 0; c < two.lattices[0].cellCount(); ++c)
    two.elastic(0).setVelocity(c, speed);
  const Vec3 before = two.momentum(0);
  CHECK(two.momentum(1) == Vec3::Zero());
  double most = 0, drift = 0;
  for (int i = 0; i < 60; ++i) {
    two.move();
    CHECK(two.steps[0].calm);
    most = std::max(most, two.momentum(1).norm());
    drift = std::max(drift, (two.momentum(0) + two.momentum(1) - before).norm());
  }
  MESSAGE("drift ", drift / before.norm(), " of the momentum");
  CHECK(most > 0.3 * before.norm());
  CHECK(drift < 1e-4 * before.norm());
}

TEST_CASE("joined blocks of cells of other sizes move in the same substeps and stay calm") {
  Joined two;
  two.add(cellsAt(Vec3::Zero()), weightless());
  two.add(cellsAt(Vec3(5.75 * kJointSpacing, 0, 0), 0.5 * kJointSpacing, {8, 8, 8}), weightless());
  // As stiff as it gets, and far beyond the nearest cells.
  two.join(5 * kJointSpacing, 1e9);
  for (std::int64_t c = 0; c < two.lattices[0].cellCount(); ++c)
    two.elastic(0).setVelocity(c, {-0.2, 0.1, 0});
  const Vec3 before = two.momentum(0);
  for (int i = 0; i < 60; ++i) {
    two.move();
    for (const TissueStep& step : two.steps) {
      CHECK(step.calm);
      CHECK(step.retries == 0);
    }
    CHECK(two.steps[0].substeps == two.steps[1].substeps);
  }
  CHECK((two.momentum(0) + two.momentum(1) - before).norm() < 1e-4 * before.norm());
}

TEST_CASE("however many cells are joined to one, substeps as long as ever follow them") {
  for (const double spacing : {kJointSpacing, 2 * kJointSpacing}) {
    Joined two;
    two.add(cellsAt(Vec3::Zero(), kJointSpacing, {12, 4, 4}), weightless());
    two.add(cellsAt(Vec3(11.5 * kJointSpacing + 0.5 * spacing, 0, 0), spacing, {2, 4, 4}),
            weightless());
    two.join(13 * kJointSpacing, 1e9);
    CHECK(two.joints.size() == 12 * 4 * 4);
    for (std::int64_t c = 0; c < two.lattices[0].cellCount(); ++c)
      two.elastic(0).setVelocity(c, {-0.05, 0.02, 0});
    const Vec3 before = two.momentum(0);
    for (int i = 0; i < 60; ++i) {
      two.move();
      for (const TissueStep& step : two.steps) CHECK(step.retries == 0);
    }
    CHECK((two.momentum(0) + two.momentum(1) - before).norm() < 1e-4 * before.norm());
  }
}

TEST_CASE("joined tissue gives the same bits at 1, 2 and 3 threads and on a second run") {
  const auto run = [](int threads) {
    TissueSettings settings;
    settings.threads = threads;
    Joined two;
    two.add(cellsAt(Vec3::Zero(), kJointSpacing, {30, 20, 12}), settings);
    two.add(cellsAt(Vec3(30 * kJointSpacing, 0, 0), kJointSpacing, {30, 20, 12}), settings);
    two.join(1.01 * kJointSpacing, 2000);
    for (int z = 0; z < 12; ++z)
      for (int y = 0; y < 20; ++y)
        two.elastic(0).hold(two.lattices[0].index({0, y, z}), kHeldAll, {0, 0.1, -0.1});
    two.move(5);
    CHECK(two.meanDisplacement(1).norm() > 0);
    return two.hash();
  };
  test::checkSameAtAnyThreads(run);
}

TEST_CASE("joined to an organ that is still, a block hangs from it as from an anchor") {
  for (const bool stillFirst : {false, true}) {
    TissueSettings settings;
    settings.drag = 8;
    Joined two;
    // The second along x; gravity draws the elastic one down.
    if (stillFirst) two.addStill(cellsAt(Vec3::Zero()));
    two.add(cellsAt(stillFirst ? kBeside : Vec3(0, 0, 0)), settings);
    if (!stillFirst) two.addStill(cellsAt(kBeside));
    two.join(1.01 * kJointSpacing, 400);
    CHECK(two.joints.size() == std::size_t(kDims.y() * kDims.z()));
    two.move(240);
    const std::size_t hanging = stillFirst ? 1 : 0;
    // The springs' pulls add up to its weight, and it no longer moves.
    Vec3 pull = Vec3::Zero();
    for (const TissueJoint& joint : two.joints)
      pull -= joint.stiffness * two.tissues[hanging]->displacement(joint.cell[hanging]);
    double mass = 0;
    for (std::int64_t c = 0; c < two.lattices[hanging].cellCount(); ++c)
      mass += two.tissues[hanging]->mass(c);
    CHECK((pull - Vec3(0, 9.81 * mass, 0)).norm() < 0.02 * 9.81 * mass);
    CHECK(two.momentum(hanging).norm() < 1e-3 * mass);
    // Without the springs it falls.
    two.joints.clear();
    const double before = two.meanDisplacement(hanging).y();
    two.move(12);
    CHECK(two.meanDisplacement(hanging).y() < before - 0.05);
  }
}
