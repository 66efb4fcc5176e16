// Coulomb's friction between tissue and obstacles: on the table, under an instrument, on a slope.
#include <doctest/doctest.h>

#include "geometry/primitives.h"
#include "support/moved_tissue.h"
#include "support/tissue_blocks.h"

using namespace resect;
using test::kFrame;
using test::moveAndTear;

namespace {

struct Slide {
  double friction, speed, turn;  // coefficient; m/s; direction in the lattice's x-z plane, rad
};

// Calls check(slide) for slow and fast motion, along the lattice and across it.
template <typename Check>
void forSlides(Check check) {
  for (const double friction : {0.1, 0.3, 0.6})
    for (const double speed : {0.005, 0.02, 0.1})
      for (const double turn : {0.0, 0.5236}) {
        CAPTURE(friction);
        CAPTURE(speed);
        CAPTURE(turn);
        check(Slide{friction, speed, turn});
      }
}

// The friction that an obstacle feels over the force with which tissue presses on it. place(t): the
// obstacle in a frame that begins at time t, s. It moves along `along`; the
// tissue presses on it along `press`.
template <typename Place>
double frictionOn(ElasticTissue& tissue, const Vec3& along, const Vec3& press, Place place) {
  TissueStep step;
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < 150; ++i) {
    const Obstacle obstacle = place(i * kFrame);
    moveAndTear(tissue, kFrame, {&obstacle, 1}, step);
    if (i >= 90) sum += step.force[0];
  }
  return -sum.dot(along) / sum.dot(press);
}

Vec3 direction(const Slide& slide) { return {std::cos(slide.turn), 0, std::sin(slide.turn)}; }

TissueSettings damped() {
  TissueSettings settings;
  settings.drag = 20;
  return settings;
}

}  // namespace

TEST_CASE("the table drawn away under a block drags it with Coulomb's friction") {
  const double s = 0.008;
  forSlides([&](const Slide& slide) {
    // Low, so that the friction does not lift its rear.
    TissueCells cells = test::solidBlock({8, 2, 8}, s, liverTissue());
    cells.lattice.origin.y() = 0.5 * s;
    ElasticTissue tissue(cells, damped());
    test::forEachCell(tissue, [&](std::int64_t c, const Vec3i& x) {
      if (x.y() == 1) tissue.hold(c, kHeldX | kHeldZ);
    });
    const Vec3 along = direction(slide);
    const double measured = frictionOn(tissue, along, -Vec3::UnitY(), [&](double t) {
      Obstacle table = tableTop();
      table.friction = slide.friction;
      table.from.position = slide.speed * t * along;
      table.to.position = slide.speed * (t + kFrame) * along;
      return table;
    });
    CHECK(measured == doctest::Approx(slide.friction).epsilon(0.03));
  });
}

TEST_CASE("an instrument drawn over tissue feels Coulomb's friction") {
  const double s = 0.005;
  const SignedDistance plate(boxMesh({{-0.3, 0, -0.3}, {0.3, 0.02, 0.3}}), 0.01, 0.003);
  forSlides([&](const Slide& slide) {
    TissueSettings settings = damped();
    settings.gravity.setZero();
    ElasticTissue tissue(test::solidBlock({8, 4, 8}, s, liverTissue()), settings);
    test::forEachCell(tissue, [&](std::int64_t c, const Vec3i& x) {
      if (x.y() == 0) tissue.hold(c, kHeldAll);
    });
    const Vec3 along = direction(slide);
    const auto pose = [&](double t) {
      const double depth = 0.1 * s * std::min(1.0, 2 * t);
      return Pose{slide.speed * t * along + Vec3(0, 3.5 * s - depth, 0),
                  Eigen::Quaterniond::Identity()};
    };
    const double measured = frictionOn(tissue, along, Vec3::UnitY(), [&](double t) {
      return test::instrument(0, &plate, pose(t), pose(t + kFrame), slide.friction, 0);
    });
    CHECK(measured == doctest::Approx(slide.friction).epsilon(0.03));
  });
}

TEST_CASE("a block on a slope rests below the angle of friction and slides above it") {
  for (const double slope : {0.2, 0.35, 0.5}) {
    CAPTURE(slope);
    TissueSettings settings;
    const double angle = std::atan(slope);
    settings.gravity = 9.81 * Vec3(std::sin(angle), -std::cos(angle), 0);
    TissueCells cells = test::solidBlock({6, 3, 6}, 0.008, test::material(20000, 0.3));
    cells.lattice.origin.y() = 0.5 * 0.008;
    ElasticTissue tissue(cells, settings);
    TissueStep step;
    const Obstacle table = tableTop();
    const auto way = [&](int frames) {
      const auto place = [&] {
        double sum = 0;
        test::forEachCell(tissue,
                          [&](std::int64_t c, const Vec3i&) { sum += tissue.displacement(c).x(); });
        return sum / 108;
      };
      const double before = place();
      for (int i = 0; i < frames; ++i) moveAndTear(tissue, kFrame, {&table, 1}, step);
      return place() - before;
    };
    way(60);
    const double first = way(30), second = way(30);  // in half a second each
    if (slope < 0.3)
      CHECK(std::abs(second) < 5e-6 * 0.5);  // no creep: below 0.005 mm/s
    else
      CHECK((second - first) / 0.25 ==
            doctest::Approx(9.81 * (std::sin(angle) - 0.3 * std::cos(angle))).epsilon(0.03));
  }
}
