// A tear takes its energy per area, whatever the lattice, the frame rate and the speed of pulling.
//
// A strip of height H with a notch from one side is held along both long edges and pulled apart
// ("pure shear", Rivlin and Thomas 1953). Where the notch's end is far from the strip's ends, a
// crack that advances by an area A releases W(stretch) H A, so it runs where W H = G.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include "support/figures.h"
#include "support/moved_tissue.h"
#include "support/tissue_blocks.h"

using namespace resect;
using test::moveAndTear;

namespace {

constexpr double kHeight = 0.048, kLength = 0.096, kWidth = 0.024, kNotch = 0.032;  // m
constexpr double kEnergy = 50;                                                      // J/m^2

struct Pulled {
  double spacing = 0.005, degrees = 0, shift = 0;  // m; of the lattice; in cells
  double speed = 0.015, frameRate = 60;            // m/s; 1/s
  double energy = kEnergy;
  int threads = 1;
};

struct Torn {
  double energy = 0;         // W H at the stretch at which a quarter of the area has torn, J/m^2
  double work = 0;           // of the edges until the strip is in two, per area, J/m^2
  bool apart = false;        // whether the two edges are in two pieces at the end
  double sum = 0;            // of all displacements, m: for a comparison of bits
  std::int64_t severed = 0;  // bonds
};

// Energy per volume of a strip that is stretched at constant width, free through its thickness.
double pureShear(const TissueMaterial& m, double stretch) {
  double least = 1e18;
  for (double thickness = 0.2; thickness < 1.05; thickness += 1e-3)
    least = std::min(least, heldEnergy(m, Vec3(1, stretch, thickness).asDiagonal()));
  return least;
}

// Area that a severed bond stands for, in squared spacings, by kind of neighbour: a plane through
// the lattice in any direction severs bonds of its own area, to some per cent (Cauchy-Crofton).
constexpr double kBondArea[4] = {0, 0.1547, 0.1298, 0.0816};

Torn pull(const Pulled& how) {
  const double s = how.spacing, angle = how.degrees * std::numbers::pi / 180;
  const Eigen::Rotation2Dd turn(angle);
  TissueMaterial tissue = test::plainLiver();
  tissue.tearEnergy = how.energy;
  TissueCells cells;
  const double grip = std::max(2 * s, 0.008);
  const int side = int(std::ceil(std::hypot(kLength, kHeight + 2 * grip) / s)) + 4;
  cells.lattice.spacing = Vec3::Constant(s);
  cells.lattice.dims = {side, side, int(std::lround(kWidth / s))};
  cells.lattice.origin = {s * (how.shift - 0.5 * (side - 1)),
                          s * (0.7 * how.shift - 0.5 * (side - 1)), 0};
  cells.materials = {tissue};
  const auto place = [&](const Vec3i& cell) -> Eigen::Vector2d {
    return turn.inverse() * cells.lattice.centre(cell).head<2>();
  };
  for (std::int64_t c = 0; c < cells.lattice.cellCount(); ++c) {
    const Eigen::Vector2d x = place(cells.lattice.cell(c));
    cells.solid.push_back(std::abs(x.x()) < kLength / 2 - 1e-9 &&
                          std::abs(x.y()) < kHeight / 2 + grip - 1e-9);
  }
  TissueSettings settings = test::weightless();
  settings.drag = 2;
  settings.threads = how.threads;
  ElasticTissue strip(cells, settings);
  std::int64_t above = -1, below = -1;
  std::vector<std::int64_t> held;
  test::forEachCell(strip, [&](std::int64_t c, const Vec3i& cell) {
    const Eigen::Vector2d x = place(cell);
    for (int d = 0; d < kDirections; ++d) {
      if (!(strip.bonds(c) >> d & 1)) continue;
      const Eigen::Vector2d to = place(cell + offsetOf(d));
      if ((x.y() > 0) == (to.y() > 0)) continue;
      const double share = x.y() / (x.y() - to.y());
      if (x.x() + share * (to.x() - x.x()) < kNotch - kLength / 2) strip.sever(c, d);
    }
    if (std::abs(x.y()) < kHeight / 2) return;
    const double speed = how.speed / 2 * (x.y() > 0 ? 1 : -1);
    const Eigen::Vector2d v = turn * Eigen::Vector2d(0, speed);
    strip.hold(c, kHeldAll, {v.x(), v.y(), 0});
    (x.y() > 0 ? above : below) = c;
    if (x.y() > 0) held.push_back(c);
  });

  Torn torn;
  const double area = (kLength - kNotch) * s * cells.lattice.dims.z();
  const Eigen::Vector2d up = turn * Eigen::Vector2d(0, 1);
  TissueStep step;
  double stretch = 1, tornArea = 0;
  for (int frame = 1; stretch < 2.4; ++frame) {
    moveAndTear(strip, 1 / how.frameRate, {}, step);
    CHECK(step.calm);
    stretch = 1 + how.speed * frame / how.frameRate / kHeight;
    double force = 0;
    for (const std::int64_t c : held) force -= strip.elasticForce(c).head<2>().dot(up);
    torn.work += force * how.speed / how.frameRate / area;
    for (const TissueBond& bond : step.torn)
      tornArea += kBondArea[neighbourKind(bond.direction)] * s * s / area;
    torn.severed += std::int64_t(step.torn.size());
    if (torn.energy == 0 && tornArea > 0.25) torn.energy = kHeight * pureShear(tissue, stretch);
    // In two, when almost no force is left.
    if (tornArea > 0.6 && force < 0.05 * how.energy * kWidth) break;
  }
  std::vector<std::uint8_t> reached(cells.solid.size(), 0);
  std::vector<std::int64_t> open = {above};
  reached[std::size_t(above)] = 1;
  while (!open.empty()) {
    const std::int64_t c = open.back();
    open.pop_back();
    for (int d = 0; d < kDirections; ++d) {
      if (!(strip.bonds(c) >> d & 1)) continue;
      const std::int64_t next = cells.lattice.index(cells.lattice.cell(c) + offsetOf(d));
      if (!std::exchange(reached[std::size_t(next)], 1)) open.push_back(next);
    }
  }
  torn.apart = !reached[std::size_t(below)];
  test::forEachCell(strip, [&](std::int64_t c, const Vec3i&) {
    torn.sum += strip.displacement(c).cwiseAbs().sum();
  });
  return torn;
}

}  // namespace

TEST_CASE("a notched strip tears at W H = G on any cells, turned and shifted in the lattice") {
  test::Figures figures("tear energy");
  double least = 1e9, most = 0;
  for (const double mm : {8.0, 5.0, 2.5})
    for (const double degrees : {0.0, 30.0})
      for (const double shift : {0.0, 0.5}) {
        if (mm < 3 && (degrees > 0) != (shift > 0)) continue;  // takes long
        const Torn torn = pull({.spacing = 1e-3 * mm, .degrees = degrees, .shift = shift});
        const std::string name =
            fmt::format("cells of {} mm, turned {}, shifted {}: ", mm, degrees, shift);
        CAPTURE(name);
        CHECK(figures.add(name + "W H at tearing", torn.energy, kEnergy, 0.25) < 0.25);
        CHECK(figures.add(name + "work per area", torn.work, kEnergy, 0.4) < 0.4);
        least = std::min(least, torn.energy);
        most = std::max(most, torn.energy);
      }
  CHECK(most / least < 1.6);
}

TEST_CASE("neither frame rate nor the speed of pulling moves the tear") {
  test::Figures figures("tear rate");
  const Torn usual = pull({});
  for (const double rate : {30.0, 120.0}) {
    const Torn torn = pull({.frameRate = rate});
    CHECK(figures.add(fmt::format("W H at {} frames per second, against that at 60", rate),
                      torn.energy, usual.energy, 0.12) < 0.12);
  }
  for (const double speed : {0.005, 0.03}) {
    const Torn torn = pull({.speed = speed});
    CHECK(figures.add(fmt::format("W H at {} mm/s, against that at 15", 1e3 * speed), torn.energy,
                      usual.energy, 0.15) < 0.15);
  }
}

TEST_CASE("twice the energy takes a greater stretch, and the work follows") {
  const Torn weak = pull({.energy = 25}), tough = pull({.energy = 100});
  CHECK(weak.energy == doctest::Approx(25).epsilon(0.25));
  CHECK(tough.energy == doctest::Approx(100).epsilon(0.25));
  CHECK(tough.work > 3 * weak.work);
}

TEST_CASE("a tear is the same, to the bit, on one thread and on four") {
  const Torn one = pull({.spacing = 0.008, .degrees = 30}),
             four = pull({.spacing = 0.008, .degrees = 30, .threads = 4});
  CHECK(one.severed == four.severed);
  CHECK(one.sum == four.sum);
}

TEST_CASE("a strip without a notch, and tissue that never tears, stay whole") {
  // Smooth tissue has no grip near; its energy at a stretch of 2.4 exceeds that of the crack.
  TissueMaterial tissue = test::plainLiver();
  tissue.tearEnergy = kEnergy;
  ElasticTissue whole(
      [&] {
        TissueCells cells = test::solidBlock({6, 8, 3}, 0.005, tissue);
        return cells;
      }(),
      test::weightless());
  test::forEachCell(whole, [&](std::int64_t c, const Vec3i& x) {
    if (x.y() == 0) whole.hold(c, kHeldAll, {0, -0.02, 0});
    if (x.y() == 7) whole.hold(c, kHeldAll, {0, 0.02, 0});
  });
  TissueStep step;
  for (int i = 0; i < 60; ++i) {
    moveAndTear(whole, 1.0 / 60, {}, step);
    CHECK(step.torn.empty());
  }
  CHECK(pull({.spacing = 0.008, .energy = std::numeric_limits<double>::infinity()}).severed == 0);
}

TEST_CASE("the older tear stretch gives the energy at which smooth tissue tears there") {
  const TissueMaterial plain = test::plainLiver();
  CHECK(energyOfStretch(plain, 1) == doctest::Approx(0).epsilon(1e-6));
  // At small strain E e^2 / 2.
  CHECK(energyOfStretch(plain, 1.01) ==
        doctest::Approx(kTearLength * 0.5 * plain.young * 1e-4).epsilon(0.02));
  double before = 0;
  for (const double stretch : {1.1, 1.46, 2.0, 4.0, 100.0}) {
    const double energy = energyOfStretch(liverTissue(), stretch);
    CHECK(energy > before);
    before = energy;
  }
}
