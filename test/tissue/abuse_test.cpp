// Extreme deformation of tissue: twists, cuts while stretched, crushing, holes.
#include <doctest/doctest.h>

#include <numbers>

#include "support/figures.h"
#include "support/references/relax.h"
#include "support/tissue_blocks.h"

using namespace resect;
using test::solidBlock;

namespace {

bool finite(const ElasticTissue& tissue) {
  bool all = true;
  test::forEachCell(tissue, [&](std::int64_t c, const Vec3i&) {
    all &= tissue.displacement(c).allFinite() && tissue.velocity(c).allFinite() &&
           tissue.deformation(c).allFinite();
  });
  return all;
}

// Frames; returns how often one had to be started again.
int run(ElasticTissue& tissue, int frames) {
  int retries = 0;
  for (int i = 0; i < frames; ++i) {
    const auto advance = tissue.advance(1.0 / 60);
    CHECK(advance.calm);
    retries += advance.retries;
  }
  return retries;
}

// Both ends of the bar move apart (or together) until it has `stretch` times its length.
void stretchTo(ElasticTissue& tissue, double stretch, int frames) {
  const int length = tissue.lattice().dims.x();
  const double way = 0.5 * (stretch - 1) * (length - 1) * tissue.lattice().spacing.x();
  const auto hold = [&](double speed) {
    test::forEachCell(tissue, [&](std::int64_t c, const Vec3i& at) {
      if (at.x() == 0) tissue.hold(c, kHeldAll, {-speed, 0, 0});
      if (at.x() == length - 1) tissue.hold(c, kHeldAll, {speed, 0, 0});
    });
  };
  hold(way / (frames / 60.0));
  run(tissue, frames);
  hold(0);
}

}  // namespace

TEST_CASE("a bar survives two full turns and comes back to its shape") {
  ElasticTissue tissue(solidBlock({24, 6, 6}, 0.005, liverTissue()), test::weightless());
  const Vec3 middle = tissue.lattice().box().centre();
  const int frames = 120;
  int retries = 0;
  for (int i = 0; i < frames; ++i) {
    test::forEachCell(tissue, [&](std::int64_t c, const Vec3i& at) {
      if (at.x() != 0 && at.x() != 23) return;
      const Vec3 x = tissue.lattice().centre(at) - middle;
      const auto placed = [&](int frame) {
        const double angle = (at.x() ? 1 : -1) * 2 * std::numbers::pi * frame / frames;
        return Vec3(x.x(), x.y() * std::cos(angle) - x.z() * std::sin(angle),
                    x.y() * std::sin(angle) + x.z() * std::cos(angle));
      };
      tissue.setDisplacement(c, placed(i) - x);
      tissue.hold(c, kHeldAll, 60 * (placed(i + 1) - placed(i)));
    });
    const auto advance = tissue.advance(1.0 / 60);
    CHECK(advance.calm);
    retries += advance.retries;
  }
  CHECK(retries == 0);
  CHECK(finite(tissue));
  CHECK(tissue.energy().elastic > 0);
  test::forEachCell(tissue, [&](std::int64_t c, const Vec3i&) { tissue.hold(c, 0); });
  CHECK(run(tissue, 360) == 0);  // the slow branch takes its time
  test::relax(tissue, 1e-7, 8000);
  CHECK(tissue.energy().elastic < 1e-6);
}

TEST_CASE("a bar cut through at stretch 1.3, 2.0 and 2.5 stays whole in numbers and loses energy") {
  for (const double stretch : {1.3, 2.0, 2.5}) {
    ElasticTissue tissue(solidBlock({24, 8, 8}, 0.005, liverTissue()), test::weightless());
    stretchTo(tissue, stretch, 60);
    for (int depth = 1; depth <= 8; ++depth) {
      const double before = tissue.energy().total();
      test::severBetween(tissue, [&](const Vec3i& at) { return at.x() >= 12 && at.y() < depth; });
      CHECK(tissue.energy().total() <= before * (1 + 1e-9));
      CHECK(run(tissue, 3) == 0);
      CHECK(finite(tissue));
      CHECK(tissue.energy().total() <= before * (1 + 1e-3));  // both ends stand still
    }
  }
}

TEST_CASE("a block crushed to a fifth of its height comes back") {
  ElasticTissue tissue(solidBlock({16, 8, 8}, 0.005, liverTissue()), test::weightless());
  stretchTo(tissue, 0.2, 60);
  CHECK(finite(tissue));
  stretchTo(tissue, 5, 60);
  CHECK(finite(tissue));
  test::forEachCell(tissue, [&](std::int64_t c, const Vec3i&) { tissue.hold(c, 0); });
  CHECK(run(tissue, 360) == 0);
  test::relax(tissue, 1e-6, 8000);
  CHECK(tissue.energy().elastic < 1e-5);
}

TEST_CASE("30, 50 and 70 % of the particles can be taken out at random while it is stretched") {
  for (const double share : {0.3, 0.5, 0.7}) {
    ElasticTissue tissue(solidBlock({24, 8, 8}, 0.005, liverTissue()), test::weightless());
    stretchTo(tissue, 1.5, 40);
    Random random(std::uint64_t(100 * share));
    double before = tissue.energy().total();
    for (int part = 0; part < 10; ++part) {
      test::forEachCell(tissue, [&](std::int64_t c, const Vec3i&) {
        if (random.uniform() < share / 10 / (1 - share * part / 10)) tissue.remove(c);
      });
      run(tissue, 2);
      const double now = tissue.energy().total();
      CHECK(now <= before * (1 + 1e-3));
      before = now;
    }
    CHECK(finite(tissue));
  }
}
