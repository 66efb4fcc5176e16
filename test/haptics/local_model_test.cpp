// The local model's stiffness is that of the simulation, wherever an instrument meets the lattice.
#include "haptics/local_model.h"

#include <doctest/doctest.h>

#include <numbers>

#include "support/moved_tissue.h"

using namespace resect;
using test::ballOf;
using test::barOf;
using test::kFrame;
using test::moveAndTear;

namespace {

constexpr double kStep = 1e-4;  // m, of the finite difference

struct Layer : test::TissueLayer {
  Layer(double s, const TissueMaterial& material) : TissueLayer(s, 0.04, 5, material) {}
};

struct Difference {
  double model, simulated;  // N/m, along the step
};

// Presses an instrument in, holds it for a second, then moves it by kStep in one frame. The change
// of the force in the frame after that, against a simulation in which it does not move, is the
// tissue's stiffness; the model tells it before the step.
Difference difference(double spacing, const SignedDistance& shape, const Vec3& shift, double depth,
                      double turn, const Vec3& step, const TissueMaterial& material) {
  LocalModel model;
  Vec3 force[2];
  for (int moves = 0; moves < 2; ++moves) {
    Layer layer(spacing, material);
    const auto pose = [&](int frame) {
      const double down = depth * std::min(1.0, frame / 20.0);
      Vec3 place = layer.top + spacing * shift - Vec3(0, down, 0);
      if (frame > 80) place += moves * kStep * step;
      return Pose{place, Eigen::Quaterniond(Eigen::AngleAxisd(turn, Vec3::UnitY()))};
    };
    TissueStep report;
    for (int i = 0; i < 82; ++i) {
      const Obstacle tool = test::instrument(0, &shape, pose(i), pose(i + 1), 0.3, 0);
      moveAndTear(layer.tissue, kFrame, {&tool, 1}, report);
      if (i != 79) continue;
      TissueTouch touch;
      layer.tissue.touchOf(0, touch);
      model = makeLocalModel({pose(79), pose(80), kFrame, report.force[0], 0.3}, {&touch, 1});
      CHECK((model.force - report.force[0]).norm() < 1e-12);  // it stands still
    }
    force[moves] = report.force[0];
  }
  return {step.dot(model.stiffness * step), -(force[1] - force[0]).dot(step) / kStep};
}

}  // namespace

TEST_CASE("the stiffness of the local model is that of the simulation") {
  const SignedDistance ball = ballOf(0.008), bar = barOf(0.012);
  for (const double spacing : {0.008, 0.005})
    for (const bool round : {true, false})
      for (const double turn : {0.0, std::numbers::pi / 6})
        for (const Vec3& shift : {Vec3(0, 0, 0), Vec3(0.25, 0, 0.4)})
          for (const bool relaxes : {false, true}) {
            if (relaxes && turn > 0) continue;
            const double depth = turn > 0 ? 0.002 : 0.004;
            const auto of = [&](const Vec3& step) {
              return difference(spacing, round ? ball : bar, shift, depth, turn, step,
                                relaxes ? liverTissue() : test::plainLiver());
            };
            const Difference down = of({0, -1, 0}), along = of({1, 0, 0});
            CAPTURE(spacing);
            CAPTURE(round);
            CAPTURE(turn);
            CAPTURE(shift.x());
            CAPTURE(relaxes);
            MESSAGE("down " << down.model << " of " << down.simulated << " N/m, along "
                            << along.model << " of " << along.simulated);
            // The layer on its rigid ground is stiffer than the half-space of the theory.
            CHECK(down.model > 0.66 * down.simulated);
            CHECK(down.model < 1.05 * down.simulated);
            // What slides at the border of the contact varies.
            CHECK(along.model > 0.5 * along.simulated);
            CHECK(along.model < 1.9 * along.simulated);
          }
}

TEST_CASE("the stiffness of a grip is that of the simulation") {
  for (const double spacing : {0.008, 0.005})
    for (const int wide : {2, 3})
      for (const Vec3& step : {Vec3(0, 1, 0), Vec3(1, 0, 0)}) {
        LocalModel model;
        Vec3 force[2];
        for (int moves = 0; moves < 2; ++moves) {
          Layer layer(spacing, liverTissue());
          const Vec3i dims = layer.cells.lattice.dims;
          const auto pose = [&](int frame) {
            Vec3 place = layer.top + Vec3(0, 0.003 * std::min(1.0, frame / 20.0), 0);
            if (frame > 80) place += moves * kStep * step;
            return Pose{place, Eigen::Quaterniond::Identity()};
          };
          for (int k = 0; k < wide * wide * 2; ++k)
            layer.tissue.grip(layer.cells.lattice.index({dims.x() / 2 + k % wide,
                                                         dims.y() - 1 - k / (wide * wide),
                                                         dims.z() / 2 + k / wide % wide}),
                              0, pose(0));
          TissueStep report;
          for (int i = 0; i < 82; ++i) {
            const Obstacle tool = test::instrument(0, nullptr, pose(i), pose(i + 1), 0.3, 0);
            moveAndTear(layer.tissue, kFrame, {&tool, 1}, report);
            if (i != 79) continue;
            TissueTouch touch;
            layer.tissue.touchOf(0, touch);
            CHECK(touch.held.size() == std::size_t(wide * wide * 2));
            model = makeLocalModel({pose(79), pose(80), kFrame, report.force[0], 0.3}, {&touch, 1});
          }
          force[moves] = report.force[0];
        }
        const double simulated = -(force[1] - force[0]).dot(step) / kStep;
        const double told = step.dot(model.stiffness * step);
        CAPTURE(spacing);
        CAPTURE(wide);
        MESSAGE("grip " << told << " of " << simulated << " N/m");
        // Sideways a wide grip turns the cells below it, and meets less.
        CHECK(told > 0.6 * simulated);
        CHECK(told < (step.x() > 0 ? 2.2 : 1.05) * simulated);
      }
}
