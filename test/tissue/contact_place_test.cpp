// Contact does not depend on where an instrument meets the lattice, nor much on the cells' size.
#include <doctest/doctest.h>

#include <numbers>

#include "support/moved_tissue.h"

using namespace resect;
using test::ballOf;
using test::barOf;
using test::kFrame;
using test::moveAndTear;

namespace {

constexpr double kTurn = std::numbers::pi / 6;

struct Layer : test::TissueLayer {
  explicit Layer(double s) : TissueLayer(s, 0.032, 30, liverTissue()) {}
};

Pose turned(const Vec3& place, double turn) {
  return {place, Eigen::Quaterniond(Eigen::AngleAxisd(turn, Vec3::UnitY()))};
}

// Force on an instrument that was pressed in by `depth` at `place`, N.
double pressedAt(Layer& layer, const SignedDistance& shape, const Vec3& place, double depth,
                 double turn) {
  TissueStep step;
  for (int i = 0; i < 60; ++i) {
    const auto pose = [&](int frame) {
      return turned(place - Vec3(0, depth * std::min(1.0, frame / 20.0), 0), turn);
    };
    const Obstacle tool = test::instrument(0, &shape, pose(i), pose(i + 1), 0, 0);
    moveAndTear(layer.tissue, kFrame, {&tool, 1}, step);
  }
  return step.force[0].y();
}

// The force's ripple, as a share of the force, while an instrument is drawn over 25 mm of tissue at
// 20 mm/s: rms about a parabola.
double ripple(double spacing, const SignedDistance& shape, double depth, double turn) {
  Layer layer(spacing);
  TissueStep step;
  const Vec3 along(std::cos(turn), 0, std::sin(turn));
  const auto pose = [&](int frame) {
    const double way = -0.014 + 0.02 * kFrame * std::max(0, frame - 20);
    return turned(layer.top + way * along - Vec3(0, depth * std::min(1.0, frame / 20.0), 0), turn);
  };
  std::vector<double> forces;
  for (int i = 0; i < 104; ++i) {
    const Obstacle tool = test::instrument(0, &shape, pose(i), pose(i + 1), 0, 0);
    moveAndTear(layer.tissue, kFrame, {&tool, 1}, step);
    if (i >= 29) forces.push_back(step.force[0].y());
  }
  const auto count = Eigen::Index(forces.size());
  Eigen::MatrixXd powers(count, 3);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double x = 2.0 * double(i) / double(count - 1) - 1;
    powers.row(i) << 1, x, x * x;
  }
  const Eigen::Map<const Eigen::VectorXd> force(forces.data(), count);
  const Eigen::VectorXd fit =
      (powers.transpose() * powers).ldlt().solve(powers.transpose() * force);
  return std::sqrt((powers * fit - force).squaredNorm() / double(count)) / force.mean();
}

}  // namespace

TEST_CASE("a bar feels the same force over a cell's centre, edge and corner") {
  const double s = 0.005;
  const SignedDistance bar = barOf(0.006);
  for (const double depth : {0.002, 0.004})
    for (const double turn : {0.0, kTurn}) {
      CAPTURE(depth);
      CAPTURE(turn);
      double least = 1, most = 0;
      for (const Vec3& place :
           {Vec3(0, 0, 0), Vec3(0.5, 0, 0.5), Vec3(0.5, 0, 0), Vec3(0.25, 0, 0.25)}) {
        Layer layer(s);
        const double force = pressedAt(layer, bar, layer.centre - s * place, depth, turn);
        MESSAGE("at " << place.x() << ", " << place.z() << " cells: " << force << " N");
        least = std::min(least, force);
        most = std::max(most, force);
      }
      CHECK(most < 1.05 * least);
    }
}

TEST_CASE("a ball as large as a cell feels nearly what it does on fine cells") {
  const SignedDistance ball = ballOf(0.008);
  for (const double depth : {0.002, 0.004}) {
    CAPTURE(depth);
    Layer fine(0.0025);
    const double expected = pressedAt(fine, ball, fine.centre, depth, 0);
    for (const double s : {0.008, 0.005})
      for (const Vec3& place : {Vec3(0, 0, 0), Vec3(0.5, 0, 0.5)}) {
        Layer layer(s);
        const double force = pressedAt(layer, ball, layer.centre - s * place, depth, 0);
        MESSAGE(s << " m: " << force << " N, fine: " << expected << " N");
        CHECK(force == doctest::Approx(expected).epsilon(0.15));
      }
  }
}

// The margin makes the edges of an instrument rounder, so that they press more tissue.
TEST_CASE("a narrow bar feels at most a quarter more than on fine cells") {
  for (const double width : {0.006, 0.012}) {
    const SignedDistance bar = barOf(width);
    Layer fine(0.0025);
    const double expected = pressedAt(fine, bar, fine.centre, 0.004, kTurn);
    for (const double s : {0.008, 0.005}) {
      Layer layer(s);
      const double force = pressedAt(layer, bar, layer.centre, 0.004, kTurn);
      MESSAGE("bar of " << width << " m, cells of " << s << " m: " << force
                        << " N, fine: " << expected << " N");
      CHECK(force > 0.95 * expected);
      CHECK(force < 1.25 * expected);
    }
  }
}

TEST_CASE("the force is smooth while an instrument is drawn over tissue") {
  const SignedDistance ball = ballOf(0.008), bar = barOf(0.012);
  for (const double turn : {0.0, kTurn}) {
    CAPTURE(turn);
    for (const double s : {0.008, 0.005}) {
      const double atBall = ripple(s, ball, 0.004, turn), atBar = ripple(s, bar, 0.003, turn);
      MESSAGE(s << " m: ball " << atBall << ", bar " << atBar);
      CHECK(atBall < 0.01);
      CHECK(atBar < 0.01);
    }
  }
}

TEST_CASE("an instrument finer than the cells does not slip between them") {
  const SignedDistance bar = barOf(0.006);
  const double s = 0.008;
  for (const Vec3& place : {Vec3(0, 0, 0), Vec3(0.5, 0, 0.5), Vec3(0.5, 0, 0)}) {
    CAPTURE(place.transpose());
    double before = 0;
    for (const double depth : {0.002, 0.004, 0.006}) {
      Layer layer(s);
      const double force = pressedAt(layer, bar, layer.centre - s * place, depth, 0);
      MESSAGE(depth << " m deep: " << force << " N");
      CHECK(force > before + 0.05);
      before = force;
    }
  }
}
