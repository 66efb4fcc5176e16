// Response to stretch, shear and pressure against the material law.
#include <doctest/doctest.h>

#include <numbers>

#include "support/figures.h"
#include "support/references/reference_tissue.h"
#include "support/references/relax.h"
#include "support/tissue_blocks.h"

using namespace resect;
using test::material;
using test::solidBlock;

namespace {

Mat3 plainCofactors(const Mat3& f) { return f.determinant() * f.inverse().transpose(); }

// First Piola-Kirchhoff stress of the material law, without the limiter.
Mat3 lawStress(const TissueMaterial& m, const Mat3& f) {
  return m.shear() * (f - plainCofactors(f)) +
         (m.lame() + m.shear()) * (f.determinant() - 1) * plainCofactors(f);
}

void putAffine(ElasticTissue& tissue, const Mat3& h) {
  const Vec3 middle = tissue.lattice().box().centre();
  test::forEachCell(tissue, [&](std::int64_t c, const Vec3i& at) {
    tissue.setDisplacement(c, h * (tissue.lattice().centre(at) - middle));
  });
}

void cutAtRandom(ElasticTissue& tissue, std::uint64_t seed, double share) {
  Random random(seed);
  test::forEachCell(tissue, [&](std::int64_t c, const Vec3i&) {
    for (int d = kFirstForward; d < kDirections; ++d)
      if ((tissue.bonds(c) >> d & 1) && random.uniform() < share) tissue.sever(c, d);
  });
}

}  // namespace

TEST_CASE("a bar between rollers shows the Young modulus and the Poisson ratio it was given") {
  test::Figures figures("moduli");
  for (const double poisson : {0.0, 0.3, 0.45, 0.49}) {
    const TissueMaterial m = material(5000, poisson);
    const int n = 5, length = 24;
    const double s = 0.005;
    ElasticTissue tissue(solidBlock({length, n, n}, s, m), test::weightless());
    const double stretch = 1e-3;
    test::forEachCell(tissue, [&](std::int64_t c, const Vec3i& at) {
      const Vec3 x =
          s * (at.cast<double>() - Vec3(0.5 * (length - 1), 0.5 * (n - 1), 0.5 * (n - 1)));
      tissue.setDisplacement(
          c, {stretch * x.x(), -0.9 * poisson * stretch * x.y(), -0.9 * poisson * stretch * x.z()});
      if (at.x() == 0 || at.x() == length - 1) tissue.hold(c, kHeldX);
    });
    CHECK(test::relax(tissue, 1e-9) < 40000);
    tissue.evaluateForces();
    double force = 0, along = 0, across = 0;
    int count = 0;
    test::forEachCell(tissue, [&](std::int64_t c, const Vec3i& at) {
      if (at.x() == 0) force += tissue.elasticForce(c).x();
      if (std::abs(at.x() - length / 2) < 3) {
        const Mat3 f = tissue.deformation(c);
        along += f(0, 0) - 1;
        across += 0.5 * (f(1, 1) + f(2, 2)) - 1;
        ++count;
      }
    });
    along /= count;
    across /= count;
    // The law is not linear: to first order in the strain, stress = E e (1 - c e), below 0.1 %.
    const double young = force / (n * n * s * s) / along;
    const std::string at = "nu " + std::to_string(poisson).substr(0, 4);
    CHECK(figures.add("Young modulus at " + at + " (Pa)", young, 5000, 0.002) < 0.002);
    if (poisson > 0)
      CHECK(figures.add("Poisson ratio at " + at, -across / along, poisson, 0.002) < 0.002);
    else
      CHECK(std::abs(across / along) < 0.002);
  }
}

TEST_CASE("stretch, shear and pressure of any size give the stress of the law") {
  test::Figures figures("law");
  const TissueMaterial m = material(5000, 0.45);
  double worst = 0;
  const auto compare = [&](const Mat3& f) {
    ElasticTissue tissue(solidBlock({7, 6, 5}, 0.005, m), test::weightless());
    putAffine(tissue, f - Mat3::Identity());
    const Mat3 expected = lawStress(m, f);
    test::forEachCell(tissue, [&](std::int64_t c, const Vec3i&) {
      worst = std::max(worst, (tissue.stress(c) - expected).norm() / m.young);
    });
  };
  for (const double stretch : {0.5, 0.8, 1.2, 1.5, 2.0}) {
    // Lateral stretch of an incompressible bar; the limiter acts beyond |cof F|^2 = 6.
    const double side = 1 / std::sqrt(stretch);
    compare(Vec3(stretch, side, side).asDiagonal());
    compare(Mat3::Identity() * std::min(stretch, 1.18));
    Mat3 shear = Mat3::Identity();
    shear(0, 1) = stretch - 1;
    compare(shear);
    compare(Eigen::AngleAxisd(2 * stretch, Vec3(1, 2, 3).normalized()).toRotationMatrix());
  }
  CHECK(figures.addError("largest error of stress / E", worst, 2e-5) < 2e-5);
}

TEST_CASE(
    "tissue stretched both ways to 1.9 or pressed to 0.35 has the stress of the law in time") {
  test::Figures figures("law far out");
  const TissueMaterial m = material(5000, 0.45);
  for (const auto& [name, f] : {std::pair("stretched to 1.9 both ways", Vec3(1.9, 1.9, 0.277)),
                                std::pair("pressed to 0.35", Vec3(1.69, 0.35, 1.69))}) {
    ElasticTissue tissue(solidBlock({7, 6, 5}, 0.005, m), test::weightless());
    putAffine(tissue, Mat3(f.asDiagonal()) - Mat3::Identity());
    test::forEachCell(tissue, [&](std::int64_t c, const Vec3i&) { tissue.hold(c, kHeldAll); });
    for (int i = 0; i < 5; ++i) tissue.advance(1.0 / 60);  // the limiter gives way
    const Mat3 stress = lawStress(m, f.asDiagonal());
    const double error = (tissue.stress(2 + 7 * (2 + 6 * 2)) - stress).norm() / stress.norm();
    CHECK(figures.addError(std::string("error of stress, ") + name, error, 1e-4) < 1e-4);
    putAffine(tissue, Mat3::Zero());
    for (int i = 0; i < 5; ++i) tissue.advance(1.0 / 60);
    CHECK(tissue.presentSubstep() == tissue.longestSubstep());
  }
}

TEST_CASE("a direction is found again from its offset") {
  for (int d = 0; d < kDirections; ++d) CHECK(directionTo(offsetOf(d)) == d);
}

TEST_CASE("an affine motion is seen exactly by every cell, before and after a random cut") {
  test::Figures figures("patch");
  Mat3 h;
  h << 0.05, 0.02, -0.03, 0.01, -0.04, 0.02, 0.03, -0.01, 0.02;
  for (const double severed : {0.0, 0.3}) {
    ElasticTissue tissue(solidBlock({9, 8, 7}, 0.005, liverTissue()), test::weightless());
    cutAtRandom(tissue, 11, severed);
    putAffine(tissue, h);
    tissue.evaluateForces();
    double worst = 0, force = 0;
    int seen = 0;
    test::forEachCell(tissue, [&](std::int64_t c, const Vec3i& at) {
      const std::int32_t i = tissue.state().box.index(at);
      if (tissue.state().kappa[i] == 0) return;
      ++seen;
      worst = std::max(worst, (tissue.deformation(c) - Mat3::Identity() - h).norm());
      if (severed == 0 && (at.array() >= 2).all() && (at.array() < Eigen::Array3i(7, 6, 5)).all())
        force = std::max(force, tissue.elasticForce(c).norm());
    });
    CHECK(seen > 350);
    const std::string when = severed > 0 ? "after" : "before";
    CHECK(figures.addError("error of F " + when + " the cut", worst, 1e-6) < 1e-6);
    if (severed == 0)
      CHECK(figures.addError("force inside / (E s^2)", force / (5000 * 0.005 * 0.005), 1e-6) <
            1e-6);
  }
}

TEST_CASE("forces are the slope of the energy, in cut blocks too") {
  test::Figures figures("slope");
  TissueCells cells = solidBlock({6, 5, 5}, 0.005, material(5000, 0.45));
  Random random(6);
  for (auto& flag : cells.solid) flag = random.uniform() > 0.1;
  test::ReferenceTissue<double> tissue(cells, 1.55);
  tissue.sever([&](int i, int j) { return (std::min(i, j) * 31 + std::max(i, j) * 17) % 5 == 0; });
  for (auto& u : tissue.u)
    u = 0.0005 * Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
  const auto forces = tissue.forces();
  double largest = 0, worst = 0;
  for (const Vec3& f : forces) largest = std::max(largest, f.norm());
  const double step = 1e-7;
  for (std::size_t i = 0; i < tissue.u.size(); i += 3)
    for (int a = 0; a < 3; ++a) {
      const double here = tissue.u[i][a];
      tissue.u[i][a] = here + step;
      const double above = tissue.energy();
      tissue.u[i][a] = here - step;
      const double below = tissue.energy();
      tissue.u[i][a] = here;
      worst = std::max(worst, std::abs(forces[i][a] + (above - below) / (2 * step)));
    }
  CHECK(figures.addError("largest |f + dU/dx| / largest force", worst / largest, 1e-6) < 1e-6);
}

TEST_CASE("a free body keeps its momentum and its spin while it shakes and is cut") {
  test::Figures figures("momentum");
  ElasticTissue tissue(solidBlock({12, 9, 7}, 0.005, liverTissue()), test::weightless());
  Random random(9);
  const Vec3 spin(3, -2, 4), drift(0.2, 0.1, -0.3);
  test::forEachCell(tissue, [&](std::int64_t c, const Vec3i& at) {
    const Vec3 x = tissue.lattice().centre(at);
    tissue.setVelocity(
        c, drift + spin.cross(x) +
               0.3 * Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)));
  });
  const auto sums = [&](Vec3& momentum, Vec3& angular, double& size, double& angularSize) {
    momentum = angular = Vec3::Zero();
    size = angularSize = 0;
    test::forEachCell(tissue, [&](std::int64_t c, const Vec3i& at) {
      const Vec3 p = tissue.mass(c) * tissue.velocity(c);
      const Vec3 x = tissue.lattice().centre(at) + tissue.displacement(c);
      momentum += p;
      angular += x.cross(p);
      size += p.norm();
      angularSize += x.cross(p).norm();
    });
  };
  Vec3 p0, l0, p1, l1;
  double size, angularSize;
  sums(p0, l0, size, angularSize);
  for (int i = 0; i < 30; ++i) {
    if (i == 10) test::severBetween(tissue, [](const Vec3i& c) { return c.x() > 5; });
    if (i == 20) cutAtRandom(tissue, 3, 0.2);
    tissue.advance(1.0 / 60);
  }
  sums(p1, l1, size, angularSize);
  CHECK(figures.addError("change of momentum / sum of m|v|", (p1 - p0).norm() / size, 1e-6) < 1e-6);
  CHECK(figures.addError("change of spin / sum of m|x x v|", (l1 - l0).norm() / angularSize, 1e-3) <
        1e-3);
}

TEST_CASE("a swinging body loses energy to the damping, and keeps it nearly when there is none") {
  test::Figures figures("energy");
  TissueSettings settings;
  {
    ElasticTissue damped(solidBlock({12, 6, 6}, 0.008, liverTissue()), settings);
    test::forEachCell(damped, [&](std::int64_t c, const Vec3i& at) {
      if (at.x() == 0) damped.hold(c, kHeldAll);
    });
    for (int i = 0; i < 180; ++i) damped.advance(1.0 / 60);
    CHECK(damped.energy().total() < 0);
  }
  settings.damping = 0;
  ElasticTissue tissue(solidBlock({12, 6, 6}, 0.008, test::plainLiver()), settings);
  test::forEachCell(tissue, [&](std::int64_t c, const Vec3i& at) {
    if (at.x() == 0) tissue.hold(c, kHeldAll);
  });
  const double start = tissue.energy().total();
  double swing = 0, worst = 0;
  for (int i = 0; i < 180; ++i) {
    tissue.advance(1.0 / 60);
    const TissueEnergy e = tissue.energy();
    swing = std::max(swing, -e.gravity);
    worst = std::max(worst, std::abs(e.total() - start));
  }
  CHECK(swing > 0);
  CHECK(figures.addError("energy error in 3 s / energy in motion", worst / swing, 0.01) < 0.01);
}

TEST_CASE("a cut adds no energy: stretched, sheared and at rest under load") {
  test::Figures figures("cut energy");
  double worst = -1e9;
  for (const double stretch : {1.05, 1.3, 2.0, 2.5})
    for (const std::uint64_t seed : {1, 2, 3}) {
      ElasticTissue tissue(solidBlock({20, 8, 8}, 0.005, liverTissue()), test::weightless());
      const double side = 1 / std::sqrt(stretch);
      putAffine(tissue, Mat3(Vec3(stretch, side, side).asDiagonal()) - Mat3::Identity());
      test::forEachCell(tissue, [&](std::int64_t c, const Vec3i& at) {
        if (at.x() == 0 || at.x() == 19) tissue.hold(c, kHeldAll);
      });
      tissue.advance(0.02);
      Random random(seed);
      const Vec3 n =
          Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)).normalized();
      for (int part = 1; part <= 4; ++part) {
        const double before = tissue.energy().total();
        test::forEachCell(tissue, [&](std::int64_t c, const Vec3i& at) {
          if (at.y() >= 2 * part) return;
          const double here = n.dot(at.cast<double>() - Vec3(10, 4, 4));
          for (int d = 0; d < kDirections; ++d)
            if (here * (here + n.dot(offsetOf(d).cast<double>())) < 0) tissue.sever(c, d);
        });
        worst = std::max(worst, (tissue.energy().total() - before) / before);
        tissue.advance(0.02);
      }
    }
  CHECK(figures.addError("largest growth of energy at a cut / energy", worst, 1e-6) < 1e-6);
}
