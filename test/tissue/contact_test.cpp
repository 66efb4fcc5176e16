// Contact with tools and table, grips, and the reported forces.
#include <doctest/doctest.h>

#include "geometry/primitives.h"
#include "support/figures.h"
#include "support/moved_tissue.h"
#include "support/tissue_blocks.h"

using namespace resect;
using test::kFrame;
using test::material;
using test::moveAndTear;
using test::solidBlock;

namespace {

Pose at(const Vec3& p) { return {p, Eigen::Quaterniond::Identity()}; }

// A block whose lowest cells stand on the table.
TissueCells onTable(const Vec3i& dims, double s, const TissueMaterial& m) {
  TissueCells cells = solidBlock(dims, s, m);
  cells.lattice.origin.y() = 0.5 * s;
  return cells;
}

double weight(const ElasticTissue& tissue) {
  double mass = 0;
  test::forEachCell(tissue, [&](std::int64_t c, const Vec3i&) { mass += tissue.mass(c); });
  return mass * tissue.settings().gravity.norm();
}

}  // namespace

TEST_CASE("a block let fall on the table comes to rest on it, and the table feels its weight") {
  TissueCells cells = onTable({8, 6, 7}, 0.008, liverTissue());
  cells.lattice.origin.y() += 0.03;
  TissueSettings settings;
  settings.drag = 3;
  ElasticTissue tissue(cells, settings);
  TissueStep step;
  const Obstacle table = tableTop();
  double lowest = 1;
  for (int i = 0; i < 240; ++i) {
    moveAndTear(tissue, kFrame, {&table, 1}, step);
    CHECK(step.calm);
    test::forEachCell(tissue, [&](std::int64_t c, const Vec3i& x) {
      lowest = std::min(lowest, cells.lattice.centre(x).y() + tissue.displacement(c).y());
    });
  }
  CHECK(lowest > 0);  // as it strikes
  test::forEachCell(tissue, [&](std::int64_t c, const Vec3i& x) {
    CHECK(cells.lattice.centre(x).y() + tissue.displacement(c).y() > 0.45 * 0.008);
  });
  CHECK(step.torn.empty());
  CHECK(-step.force[0].y() == doctest::Approx(weight(tissue)).epsilon(0.01));
  CHECK(std::hypot(step.force[0].x(), step.force[0].z()) < 0.02 * weight(tissue));
}

TEST_CASE("a ball pressed into a layer feels the force of Hertz, corrected for the layer") {
  test::Figures figures("hertz");
  const double s = 0.002, radius = 25 * s;
  const int height = 16;
  const TissueMaterial m = material(5000, 0.45);
  TissueSettings settings = test::weightless();
  settings.drag = 40;
  TissueCells cells = solidBlock({40, height, 40}, s, m);
  ElasticTissue tissue(cells, settings);
  test::forEachCell(tissue, [&](std::int64_t c, const Vec3i& x) {
    if (x.y() == 0) tissue.hold(c, kHeldAll);
  });
  const SignedDistance ball(sphereMesh(Vec3::Zero(), radius, 192), 2 * s, 0.5 * s);
  const Vec3 top = cells.lattice.origin + s * Vec3(19.5, height - 0.5, 19.5);
  // The layer begins at the wall of the held cells.
  const double layer = (height - 0.83) * s;
  TissueStep step;
  for (const double depth : {1.0 * s, 1.5 * s, 2.0 * s}) {
    const Pose pose = at(top + Vec3(0, radius - depth, 0));
    const Obstacle tool = test::instrument(0, &ball, pose, pose, 0, 0);
    for (int i = 0; i < 20; ++i) moveAndTear(tissue, kFrame, {&tool, 1}, step);
    // Dimitriadis et al. (2002), a layer bonded to its ground.
    const double nu = m.poisson;
    const double a0 = -(1.2876 - 1.4678 * nu + 1.3442 * nu * nu) / (1 - nu);
    const double b0 = (0.6387 - 1.0277 * nu + 1.5164 * nu * nu) / (1 - nu);
    const double chi = std::sqrt(radius * depth) / layer, pi = 3.14159265358979;
    const double correction =
        1 - 2 * a0 / pi * chi + 4 * a0 * a0 / (pi * pi) * chi * chi -
        8 / (pi * pi * pi) * (a0 * a0 * a0 + 4 * pi * pi / 15 * b0) * chi * chi * chi +
        16 * a0 / (pi * pi * pi * pi) * (a0 * a0 * a0 + 3 * pi * pi / 5 * b0) * chi * chi * chi *
            chi;
    const double expected =
        4 * m.young / (3 * (1 - nu * nu)) * std::sqrt(radius) * std::pow(depth, 1.5) * correction;
    const double allowed = 0.01;
    CHECK(
        figures.add("force at a depth of " + std::to_string(depth / s).substr(0, 3) + " cells (N)",
                    step.force[0].y(), expected, allowed) < allowed);
  }
}

TEST_CASE("what presses on a block on the table is felt by the table") {
  const double s = 0.008;
  TissueSettings settings;
  settings.drag = 20;
  ElasticTissue tissue(onTable({10, 6, 10}, s, liverTissue()), settings);
  const SignedDistance ball(sphereMesh(Vec3::Zero(), 0.02, 64), 0.01, 0.001);
  TissueStep step;
  Pose from = at({4.5 * s, 6 * s + 0.02, 4.5 * s});
  for (int i = 0; i < 120; ++i) {
    const Pose to = at({4.5 * s, std::max(5 * s, 6 * s - i * 0.0003) + 0.02, 4.5 * s});
    const Obstacle around[] = {test::instrument(0, &ball, from, to, 0.3, 0), tableTop()};
    moveAndTear(tissue, kFrame, around, step);
    from = to;
  }
  CHECK(step.force[0].y() > 0.3);
  CHECK(-step.force[1].y() == doctest::Approx(weight(tissue) + step.force[0].y()).epsilon(0.02));
}

TEST_CASE(
    "a grip lifts a block off the table, bears its weight, slips above its force, and lets go") {
  const double s = 0.008;
  const TissueCells cells = onTable({6, 5, 6}, s, material(20000, 0.45));
  for (const double slip : {100.0, 0.5}) {
    TissueSettings settings;
    settings.drag = 8;
    ElasticTissue tissue(cells, settings);
    Pose from = at({2.5 * s, 5 * s, 2.5 * s});
    for (int x = 1; x < 5; ++x)
      for (int z = 1; z < 5; ++z)
        for (int y = 3; y < 5; ++y) tissue.grip(cells.lattice.index({x, y, z}), 7, from);
    CHECK(tissue.gripped(7) == 32);
    TissueStep step;
    bool slipped = false;
    for (int i = 0; i < 150; ++i) {
      Pose to = from;
      if (i < 60) to.position.y() += 0.001;
      const Obstacle around[] = {test::instrument(7, nullptr, from, to, 0.3, slip), tableTop()};
      moveAndTear(tissue, kFrame, around, step);
      slipped |= !step.letGo.empty();
      from = to;
    }
    CHECK(slipped == (slip < weight(tissue)));
    if (slipped) {
      CHECK(tissue.gripped(7) == 0);
      CHECK(-step.force[1].y() == doctest::Approx(weight(tissue)).epsilon(0.05));
    } else {
      CHECK(step.force[1].norm() < 1e-6);
      CHECK(-step.force[0].y() == doctest::Approx(weight(tissue)).epsilon(0.01));
      tissue.release(7);
      CHECK(tissue.gripped(7) == 0);
    }
  }
}

TEST_CASE("a grip that pulls tissue beyond its strength tears it, cell by cell") {
  const double s = 0.005;
  const TissueCells cells = solidBlock({16, 5, 5}, s, liverTissue());
  ElasticTissue tissue(cells, test::weightless());
  Pose from = at({0.075, 0.01, 0.01});
  test::forEachCell(tissue, [&](std::int64_t c, const Vec3i& x) {
    if (x.x() == 0) tissue.hold(c, kHeldAll);
    if (x.x() == 15) tissue.grip(c, 0, from);
  });
  TissueStep step;
  int torn = 0, frames = 0;
  for (; frames < 160; ++frames) {
    Pose to = from;
    to.position.x() += 0.08 / 60;
    const Obstacle tool = test::instrument(0, nullptr, from, to, 0, 0);
    moveAndTear(tissue, kFrame, {&tool, 1}, step);
    CHECK(step.calm);
    torn += int(step.torn.size());
    if (frames < 20) CHECK(torn == 0);  // stretched by a third
    from = to;
  }
  CHECK(torn > 100);
  CHECK(tissue.energy().elastic < 0.05);
}

TEST_CASE("a strand that a cut has left tears when it is stretched, the whole block does not") {
  const double s = 0.005;
  for (const bool strand : {true, false}) {
    ElasticTissue tissue(solidBlock({12, 5, 5}, s, liverTissue()), test::weightless());
    // Cut across but for the bonds of one cell in the middle.
    if (strand)
      test::forEachCell(tissue, [&](std::int64_t c, const Vec3i& x) {
        if (x.x() != 5) return;
        for (int d = 0; d < kDirections; ++d)
          if (offsetAlong(d, 0) == 1 && !(x.y() == 2 && x.z() == 2 && neighbourKind(d) == 1))
            tissue.sever(c, d);
      });
    test::forEachCell(tissue, [&](std::int64_t c, const Vec3i& x) {
      if (x.x() == 0) tissue.hold(c, kHeldAll, {-0.012, 0, 0});
      if (x.x() == 11) tissue.hold(c, kHeldAll, {0.012, 0, 0});
    });
    TissueStep step;
    int torn = 0;
    for (int i = 0; i < 90; ++i) {
      moveAndTear(tissue, kFrame, {}, step);
      torn += int(step.torn.size());
    }
    CHECK((torn > 0) == strand);
  }
}

TEST_CASE("the faces of a cut do not pass through each other when they are pressed together") {
  const double s = 0.005;
  const TissueCells cells = solidBlock({12, 6, 6}, s, liverTissue());
  ElasticTissue tissue(cells, test::weightless());
  test::severBetween(tissue, [](const Vec3i& c) { return c.x() >= 6; });
  test::forEachCell(tissue, [&](std::int64_t c, const Vec3i& x) {
    if (x.x() == 0) tissue.hold(c, kHeldAll, {0.005, 0, 0});
    if (x.x() == 11) tissue.hold(c, kHeldAll, {-0.005, 0, 0});
  });
  TissueStep step;
  for (int i = 0; i < 60; ++i) moveAndTear(tissue, kFrame, {}, step);
  double closest = 1;
  for (int y = 0; y < 6; ++y)
    for (int z = 0; z < 6; ++z) {
      const auto x = [&](int column) {
        return s * column + tissue.displacement(cells.lattice.index({column, y, z})).x();
      };
      closest = std::min(closest, x(6) - x(5));
    }
  CHECK(closest > 0.5 * s);
  CHECK(tissue.energy().elastic > 0);  // both halves are pressed
}

TEST_CASE("a tool driven through at 1 m/s, or teleported, leaves tissue whole in numbers") {
  const double s = 0.008;
  const SignedDistance ball(sphereMesh(Vec3::Zero(), 0.012, 64), 0.01, 0.001);
  for (const bool teleports : {false, true}) {
    TissueSettings settings;
    settings.drag = 4;
    ElasticTissue tissue(onTable({12, 8, 12}, s, liverTissue()), settings);
    TissueStep step;
    Random random(2);
    Pose from = at({-0.1, 0.03, 0.04});
    for (int i = 0; i < 90; ++i) {
      Pose to = from;
      if (teleports)
        to.position = Vec3(random.uniform(0, 0.1), random.uniform(0, 0.07), random.uniform(0, 0.1));
      else
        to.position.x() = -0.1 + 0.3 * std::abs((i % 36) / 18.0 - 1);
      const Obstacle around[] = {test::instrument(0, &ball, from, to, 0.3, 0), tableTop()};
      moveAndTear(tissue, kFrame, around, step);
      CHECK(step.calm);
      from = to;
    }
    test::forEachCell(tissue, [&](std::int64_t c, const Vec3i&) {
      CHECK(tissue.displacement(c).allFinite());
      CHECK(tissue.displacement(c).norm() < 2);
    });
  }
}

TEST_CASE("pins hold, and a ligament bears an organ's weight") {
  const TissueCells cells = solidBlock({8, 6, 6}, 0.008, material(20000, 0.45));
  TissueSettings settings;
  settings.drag = 10;
  ElasticTissue pinned(cells, settings), hung(cells, settings);
  TissueAttachment attachment;
  attachment.box = {{-1, 0.036, -1}, {1, 0.044, 1}};
  CHECK(pinned.attach(attachment) == 48);
  attachment.kind = TissueAttachment::Kind::Ligament;
  attachment.stiffness = 500;
  CHECK(hung.attach(attachment) == 48);
  TissueStep step;
  for (int i = 0; i < 200; ++i) {
    moveAndTear(pinned, kFrame, {}, step);
    moveAndTear(hung, kFrame, {}, step);
  }
  double sag = 0;
  test::forEachCell(pinned, [&](std::int64_t c, const Vec3i& x) {
    if (x.y() != 5) return;
    CHECK(pinned.displacement(c) == Vec3::Zero());
    sag -= hung.displacement(c).y() / 48;
  });
  CHECK(sag == doctest::Approx(weight(hung) / 500).epsilon(0.02));
}
