// Maxwell branches and stiffening against their laws.
#include <doctest/doctest.h>

#include <complex>
#include <numbers>

#include "support/figures.h"
#include "support/tissue_blocks.h"

using namespace resect;
using test::solidBlock;

namespace {

TissueMaterial viscous() {
  TissueMaterial m = test::material(5000, 0.45);
  m.branches = {{0.65, 0.58}, {1.15, 0.026}};
  return m;
}

// Modulus of the series over mu, t seconds after a step.
double series(const TissueMaterial& m, double t) {
  double sum = 1;
  for (const Relaxation& b : m.branches) sum += b.share * std::exp(-t / b.time);
  return sum;
}

// Loss factor of the series at a frequency, 1/s.
double lossFactor(const TissueMaterial& m, double frequency) {
  std::complex<double> modulus = 1;
  for (const Relaxation& b : m.branches) {
    const std::complex<double> x(0, 2 * std::numbers::pi * frequency * b.time);
    modulus += b.share * x / (1.0 + x);
  }
  return modulus.imag() / modulus.real();
}

// Every cell is held, so that the block has the gradient that it is given.
ElasticTissue heldBlock(const TissueMaterial& m) {
  ElasticTissue tissue(solidBlock({5, 4, 4}, 0.006, m), test::weightless());
  test::forEachCell(tissue, [&](std::int64_t c, const Vec3i&) { tissue.hold(c, kHeldAll); });
  return tissue;
}

void put(ElasticTissue& tissue, const Mat3& f) {
  test::forEachCell(tissue, [&](std::int64_t c, const Vec3i& at) {
    tissue.setDisplacement(c, (f - Mat3::Identity()) * tissue.lattice().centre(at));
  });
}

// Lets the block move with this rate of its gradient for `duration` s.
void move(ElasticTissue& tissue, const Mat3& rate, double duration) {
  test::forEachCell(tissue, [&](std::int64_t c, const Vec3i& at) {
    tissue.hold(c, kHeldAll, rate * tissue.lattice().centre(at));
  });
  tissue.advance(duration);
}

Mat3 sheared(double by) {
  Mat3 f = Mat3::Identity();
  f(0, 1) = by;
  return f;
}

constexpr std::int64_t kMiddle = 2 + 5 * (1 + 4 * 1);

}  // namespace

TEST_CASE("a step in shear relaxes as the series says, and at rest no stress is left of it") {
  test::Figures figures("relaxation");
  const TissueMaterial m = viscous();
  for (const double strain : {0.02, 0.3}) {
    ElasticTissue tissue = heldBlock(m);
    const Mat3 turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    put(tissue, turn * sheared(strain));
    double t = 0, worst = 0;
    for (int i = 0; i < 600; ++i) {
      tissue.advance(1.0 / 120);
      t += 1.0 / 120;
      const double stress = (turn.transpose() * tissue.stress(kMiddle))(0, 1);
      worst = std::max(worst, std::abs(stress / (m.shear() * strain * series(m, t)) - 1));
    }
    // In large shear a branch relaxes from other stresses than the series' linear ones.
    const double allowed = strain < 0.1 ? 0.01 : 0.02;
    CHECK(figures.addError(fmt::format("largest error against the series, shear {:.2f}", strain),
                           worst, allowed) < allowed);
    put(tissue, Mat3::Identity());
    for (int i = 0; i < 1200; ++i) tissue.advance(1.0 / 120);
    CHECK(tissue.stress(kMiddle).norm() < 1e-4 * m.shear());
  }
}

TEST_CASE("the loss factor of liver is 0.2 to 0.3 from 0.1 to 10 Hz, and that of its series") {
  test::Figures figures("loss factor");
  const TissueMaterial m = viscous();
  for (const double frequency : {0.1, 0.3, 1.0, 3.0, 10.0}) {
    ElasticTissue tissue = heldBlock(m);
    const int cycles = frequency < 1 ? 2 : 6;
    const double strain = 0.05, omega = 2 * std::numbers::pi * frequency;
    const int frames = int(std::max(48.0, 60 / frequency));
    const double dt = 1 / (frequency * frames);
    std::complex<double> response = 0;
    double before = 0;
    for (int i = 1; i <= cycles * frames; ++i) {
      const double now = strain * std::sin(omega * i * dt);
      Mat3 rate = Mat3::Zero();
      rate(0, 1) = (now - before) / dt;
      move(tissue, rate, dt);
      before = now;
      if (i > (cycles - 1) * frames)
        response += tissue.stress(kMiddle)(0, 1) * std::polar(1.0, -omega * i * dt);
    }
    // Of a sine: the response has the phase -90 degrees plus that of the modulus.
    const std::complex<double> modulus = response * std::complex<double>(0, 1);
    const double loss = modulus.imag() / modulus.real();
    CHECK(loss > 0.2);
    CHECK(loss < 0.3);
    CHECK(figures.add(fmt::format("at {:.1f} Hz", frequency), loss, lossFactor(m, frequency),
                      0.04) < 0.04);
  }
}

TEST_CASE("shear stiffens as the square of the strain, up to the cap") {
  test::Figures figures("stiffening");
  TissueMaterial m = test::material(5000, 0.45);
  m.stiffening = 2;
  double worst = 0;
  for (const double strain : {0.05, 0.2, 0.5, 1.0, 1.4}) {
    ElasticTissue tissue = heldBlock(m);
    put(tissue, sheared(strain));
    for (int i = 0; i < 4; ++i) tissue.advance(1.0 / 60);  // the limiter gives way
    const double law =
        m.shear() * strain * (1 + std::min(2 * strain * strain, double(kMostStiffening)));
    worst = std::max(worst, std::abs(tissue.stress(kMiddle)(0, 1) / law - 1));
  }
  CHECK(figures.addError("largest error in shear from 0.05 to 1.4", worst, 1e-5) < 1e-5);
}

TEST_CASE("the forces of viscous, stiffening tissue are those of the stress in every cell") {
  TissueMaterial m = viscous();
  m.stiffening = 2;
  // An affine motion of free cells: inside, the forces cancel; on the faces they are P n.
  ElasticTissue tissue(solidBlock({6, 6, 6}, 0.006, m), test::weightless());
  test::forEachCell(tissue, [&](std::int64_t c, const Vec3i&) { tissue.hold(c, kHeldAll); });
  Mat3 f = sheared(0.3);
  f(2, 2) = 0.8, f(1, 0) = -0.1;
  put(tissue, f);
  for (int i = 0; i < 6; ++i) tissue.advance(1.0 / 60);
  tissue.evaluateForces();
  const Mat3 stress = tissue.stress(2 + 6 * (2 + 6 * 2));
  Vec3 face = Vec3::Zero();
  double inside = 0;
  test::forEachCell(tissue, [&](std::int64_t c, const Vec3i& at) {
    if (at.x() <= 2) face += tissue.elasticForce(c);
    if ((at.array() >= 2).all() && (at.array() <= 3).all())
      inside = std::max(inside, tissue.elasticForce(c).norm());
  });
  const double area = std::pow(6 * 0.006, 2);
  CHECK(inside < 1e-4 * stress.norm() * 0.006 * 0.006);
  CHECK((face - area * stress.col(0)).norm() < 0.15 * area * stress.col(0).norm());
}

TEST_CASE("viscous tissue that swings comes to rest and never gains energy") {
  TissueMaterial m = viscous();
  m.stiffening = 2;
  TissueSettings settings = test::weightless();
  ElasticTissue tissue(solidBlock({16, 5, 5}, 0.008, m), settings);
  test::forEachCell(tissue, [&](std::int64_t c, const Vec3i& at) {
    if (at.x() == 0) tissue.hold(c, kHeldAll);
    tissue.setVelocity(c, {0, 0.04 * at.x(), 0});
  });
  const double start = tissue.energy().total();
  double last = start, most = 0;
  for (int i = 0; i < 240; ++i) {
    tissue.advance(1.0 / 60);
    const double now = tissue.energy().total();
    most = std::max(most, now - last);
    last = now;
  }
  CHECK(most < 1e-3 * start);
  CHECK(last < 0.02 * start);
}
