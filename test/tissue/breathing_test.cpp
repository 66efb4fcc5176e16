// Breathing: its waveform, and tissue whose pins and ligaments it moves.
#include "tissue/breathing.h"

#include <doctest/doctest.h>

#include "base/parallel.h"
#include "support/tissue_blocks.h"
#include "tissue/move_tissues.h"

using namespace resect;
using test::kFrame;

namespace {

const Breathing kUsual{0.01, 12, 0.8, true};

// A block that is pinned at its upper face.
ElasticTissue pinnedBlock(int threads = 1) {
  TissueSettings settings;
  settings.drag = 2;
  settings.threads = threads;
  ElasticTissue tissue(test::solidBlock({20, 8, 12}, 0.008, liverTissue()), settings);
  TissueAttachment pin;
  pin.box = {{-1, 0.052, -1}, {1, 0.06, 1}};
  REQUIRE(tissue.attach(pin) == 240);
  return tissue;
}

std::vector<std::int64_t> heldCells(const ElasticTissue& tissue) {
  std::vector<std::int64_t> cells;
  test::forEachCell(tissue, [&](std::int64_t c, const Vec3i&) {
    if (tissue.state().held[tissue.state().box.fromLattice(c)] == kHeldAll) cells.push_back(c);
  });
  return cells;
}

TissueStep moveBreathing(ElasticTissue& tissue, const BreathMotion& motion) {
  TissueStep step;
  tissue.moveHolds(motion);
  moveTissue(tissue, {}, motion.duration, step);
  return step;
}

}  // namespace

TEST_CASE("a breath begins and ends at rest, is deepest in its middle, and lasts as it should") {
  Breath breath;
  double time = 0, deepest = 0, deepestAt = 0;
  for (int i = 0; i < 300; ++i) {  // 5 s: one breath of twelve a minute
    const BreathMotion motion = breathe(kUsual, breath, kFrame);
    CHECK(motion.displacement(0).x() == 0);
    CHECK(motion.displacement(0).y() == 0);
    // The velocity is the slope of the displacement.
    const double slope = (motion.displacement(0.51).z() - motion.displacement(0.49).z()) / 0.02;
    CHECK(motion.velocity(0.5).z() == doctest::Approx(slope / kFrame).epsilon(1e-4));
    if (i == 0) CHECK(motion.displacement(0) == Vec3::Zero());
    if (i == 0) CHECK(motion.velocity(0) == Vec3::Zero());
    time += kFrame;
    if (motion.displacement(1).z() > deepest) {
      deepest = motion.displacement(1).z();
      deepestAt = time;
    }
  }
  CHECK(deepest == doctest::Approx(0.01));
  CHECK(deepestAt == doctest::Approx(2.5));
  // After 300 frames one breath is over, to rounding.
  CHECK(std::min(breath.phase, 1 - breath.phase) < 1e-12);
  // Half of the time the displacement is less than a quarter of the depth.
  CHECK(breathWave(0.25) == doctest::Approx(0.25));
}

TEST_CASE("a breath that is held ends first, and the next one begins at rest") {
  Breath breath;
  for (int i = 0; i < 100; ++i) breathe(kUsual, breath, kFrame);
  breath.on = false;
  double before = 10, speed = 0;
  for (int i = 100; i < 310; ++i) {
    const BreathMotion motion = breathe(kUsual, breath, kFrame);
    const double now = motion.displacement(1).z();
    if (before < 1) CHECK(std::abs((now - before) / kFrame - speed) < 4e-4);  // it never jerks
    speed = (now - motion.displacement(0).z()) / kFrame;
    before = now;
  }
  CHECK(breath.phase == 0);
  CHECK(before == 0);
  breath.on = true;
  const BreathMotion motion = breathe(kUsual, breath, kFrame);
  CHECK(motion.velocity(0) == Vec3::Zero());
  CHECK(motion.displacement(1).z() > 0);
}

TEST_CASE("pinned cells follow the diaphragm, at every frame of a minute") {
  ElasticTissue tissue = pinnedBlock();
  const std::vector<std::int64_t> held = heldCells(tissue);
  REQUIRE(held.size() == 240);
  Breath breath;
  double worst = 0;
  for (int i = 0; i < 3600; ++i) {
    const BreathMotion motion = breathe(kUsual, breath, kFrame);
    const TissueStep step = moveBreathing(tissue, motion);
    REQUIRE(step.calm);
    REQUIRE(step.retries == 0);
    for (const std::int64_t c : held)
      worst = std::max(worst, (tissue.displacement(c) - motion.displacement(1)).norm());
  }
  CHECK(worst < 1e-8);  // m; rounding does not add up
}

TEST_CASE("what hangs from pins follows them, and a held breath brings it back to where it hung") {
  ElasticTissue tissue = pinnedBlock(), still = pinnedBlock();
  Breath breath;
  const auto mean = [](const ElasticTissue& t) {
    double z = 0;
    test::forEachCell(t, [&](std::int64_t c, const Vec3i& x) {
      if (x.y() == 0) z += t.displacement(c).z() / 240;
    });
    return z;
  };
  double lowest = 0;
  for (int i = 0; i < 1200; ++i) {
    if (i == 400) breath.on = false;
    moveBreathing(tissue, breathe(kUsual, breath, kFrame));
    still.advance(kFrame);
    lowest = std::max(lowest, mean(tissue) - mean(still));
  }
  CHECK(lowest == doctest::Approx(0.01).epsilon(0.1));  // of the cells that hang farthest below
  CHECK(std::abs(mean(tissue) - mean(still)) < 1e-5);
}

TEST_CASE("ligaments are moved by breathing as pins are") {
  TissueSettings settings = test::weightless();
  settings.drag = 2;
  ElasticTissue tissue(test::solidBlock({8, 6, 6}, 0.008, liverTissue()), settings);
  TissueAttachment ligament;
  ligament.kind = TissueAttachment::Kind::Ligament;
  ligament.box = {{-1, 0.036, -1}, {1, 0.044, 1}};
  ligament.stiffness = 300;
  REQUIRE(tissue.attach(ligament) == 48);
  Breath breath;
  double deepest = 0;
  for (int i = 0; i < 600; ++i) {
    moveBreathing(tissue, breathe(kUsual, breath, kFrame));
    double z = 0;
    test::forEachCell(tissue, [&](std::int64_t c, const Vec3i&) {
      z += tissue.displacement(c).z() / (8 * 6 * 6);
    });
    deepest = std::max(deepest, z);
  }
  CHECK(deepest == doctest::Approx(0.01).epsilon(0.05));
}

TEST_CASE("breathing of no depth changes no bit, and threads change none") {
  ElasticTissue still = pinnedBlock(), flat = pinnedBlock(), one = pinnedBlock(),
                many = pinnedBlock(3);
  const Breathing none{0, 12, 0.8, true};
  Breath breathFlat, breath, breathMany;
  for (int i = 0; i < 150; ++i) {
    still.advance(kFrame);
    moveBreathing(flat, breathe(none, breathFlat, kFrame));
    moveBreathing(one, breathe(kUsual, breath, kFrame));
    moveBreathing(many, breathe(kUsual, breathMany, kFrame));
  }
  HashVisitor a, b, c, d;
  still.visit(a), flat.visit(b), one.visit(c), many.visit(d);
  CHECK(a.value() == b.value());
  CHECK(c.value() == d.value());
  CHECK(a.value() != c.value());
}
