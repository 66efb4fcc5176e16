// Cutting by energy: a straight edge through a block, as in the "pure shear" and "guillotine" tests
// of Atkins (The Science and Engineering of Cutting, 2009).
//
// The block is held along both long sides, and the edge, which is longer than the block is wide,
// moves lengthwise through its middle. With the cut energy J and the width w, the force is J w in a
// straight push. When the edge also moves along itself, xi times as fast, the force is
// J w / (1 + xi^2) forwards and xi times that along the edge.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "base/random.h"
#include "support/figures.h"
#include "support/tissue_blocks.h"
#include "tissue/cut_bonds.h"
#include "tissue/elastic/elastic_tissue.h"
#include "tissue/move_tissues.h"

using namespace resect;
using test::kFrame;

namespace {

constexpr double kBlockHeight = 0.05;  // of the block, m
constexpr double kJ = 50;              // J/m^2; over Young's modulus: 10 mm

struct Cut {
  double spacing = 0.005, degrees = 0;  // m; of the block in the lattice
  double speed = 0.02, xi = 0;          // m/s forwards; along the edge, as a multiple
  double length = 0.08, width = 0.02;   // of the block, m
  double from = 0.2, to = 0.6;          // forces are means while the front is there, shares
  double energy = kJ, perSkin = 0;      // J/m^2; J/m
  double aside = 0.0013;                // of the cut from the middle of the lattice, m
  int threads = 1;
  bool touch = true;  // whether the faces of the cut do
};

struct Outcome {
  double force = 0, along = 0;  // means, over J w
  double largest = 0;           // force at any time, over J w
  double work = 0, cut = 0;     // work of the hand, work of cutting, J
  double expected = 0;          // J times the area cut, J
  double unexplained = 0;       // of the hand's work, share
  std::int64_t severed = 0;     // bonds
  double sum = 0;               // of all displacements, for a comparison of bits
};

// A block under an edge that moves along the block's x axis.
class Guillotine {
 public:
  explicit Guillotine(const Cut& how)
      : how_(how),
        turn_(Eigen::AngleAxisd(how.degrees * std::numbers::pi / 180, Vec3::UnitZ())),
        cells_(cells()),
        tissue(cells_, settings()) {
    const auto height = [&](std::int64_t c) { return std::abs(placeAtRest(c).y()); };
    for (std::int64_t c = 0; c < cells_.lattice.cellCount(); ++c)
      if (tissue.solid(c) && height(c) > kBlockHeight / 2) tissue.hold(c, kHeldAll);
    x = -how.length / 2 - 0.002;
    if (how.perSkin > 0) tissue.setSurface(frontFace());
  }

  double width() const { return how_.spacing * (cells_.lattice.dims.z() - 2); }
  // One frame. Returns the force on the edge in the block's axes, N.
  Vec3 advance(double speed) {
    const Pose from = pose();
    x += speed * kFrame;
    z += how_.xi * speed * kFrame;
    const CuttingEdge edge{points_, Vec3::UnitY(), from, pose()};
    Obstacle tool;
    tool.tool = 0;
    tool.edges = {&edge, 1};
    const TissueEnergy before = tissue.energy();
    moveTissue(tissue, {&tool, 1}, kFrame, step_);
    const TissueEnergy moved = tissue.energy();
    const CutWork cut = tissue.cutWork();
    work += cut.given;
    took += cut.given - cut.taken - (cut.held - held_);
    held_ = cut.held;
    expected += cut.cut;
    // What the edge gave to the tissue and did not become its energy: the damping of the method.
    lost += cut.taken - (moved.total() - before.total());
    for (const TissueCut& one : step_.cuts)
      for (const TissueBond& bond : crossedBonds(tissue, cells_.lattice, one.blade)) {
        tissue.sever(bond.cell, bond.direction);
        ++severed;
      }
    tissue.settle();
    return turn_.inverse() * step_.force[0];
  }
  // Where the front of the cut is, m along x; far behind if the edge is nowhere in tissue.
  double front() const {
    double sum = 0;
    int ties = 0;
    for (const CutFront& front : tissue.fronts())
      for (const CutSample& sample : front.samples)
        if (sample.tied) {
          sum += (turn_.inverse() * sample.place).x();
          ++ties;
        }
    return ties > 0 ? sum / ties : -1;
  }
  double displacements() const {
    double sum = 0;
    for (std::int64_t c = 0; c < cells_.lattice.cellCount(); ++c)
      if (tissue.solid(c)) sum += tissue.displacement(c).sum();
    return sum;
  }

 private:
  TissueCells cells() const {
    const double s = how_.spacing, grip = std::max(s, 0.008);
    TissueCells cells;
    const int side = int(std::ceil(std::hypot(how_.length, kBlockHeight + 2 * grip) / s)) + 4;
    cells.lattice.spacing = Vec3::Constant(s);
    cells.lattice.dims = {side, side, int(std::lround(how_.width / s)) + 2};
    cells.lattice.origin = -0.5 * s * (cells.lattice.dims - Vec3i::Ones()).cast<double>();
    TissueMaterial tissue = test::plainLiver();
    tissue.tearEnergy = std::numeric_limits<double>::infinity();
    tissue.cutEnergy = how_.energy;
    tissue.capsuleCutEnergy = how_.perSkin;
    cells.materials = {tissue};
    for (std::int64_t c = 0; c < cells.lattice.cellCount(); ++c) {
      const Vec3i at = cells.lattice.cell(c);
      const Vec3 x = turn_.inverse() * cells.lattice.centre(at);
      cells.solid.push_back(at.z() > 0 && at.z() + 1 < cells.lattice.dims.z() &&
                            std::abs(x.x()) < how_.length / 2 - 1e-9 &&
                            std::abs(x.y()) < kBlockHeight / 2 + grip - 1e-9);
    }
    return cells;
  }
  TissueSettings settings() const {
    TissueSettings settings = test::weightless();
    settings.damping = 0;
    settings.threads = how_.threads;
    settings.facesTouch = how_.touch;
    return settings;
  }
  // The face that the edge enters, of a block that is not turned.
  std::vector<SurfacePatch> frontFace() const {
    std::vector<SurfacePatch> patches;
    const double s = how_.spacing;
    for (std::int64_t c = 0; c < cells_.lattice.cellCount(); ++c) {
      const Vec3i at = cells_.lattice.cell(c);
      if (!cells_.solid[std::size_t(c)] || at.x() == 0) continue;
      if (cells_.solid[std::size_t(c) - 1]) continue;
      const Vec3 place = cells_.lattice.centre(at) - 0.5 * s * Vec3::UnitX();
      patches.push_back({c, place.cast<float>(), (-s * s * Vec3::UnitX()).cast<float>()});
    }
    return patches;
  }
  Vec3 placeAtRest(std::int64_t c) const {
    return turn_.inverse() * cells_.lattice.centre(cells_.lattice.cell(c));
  }
  Pose pose() const { return {turn_ * Vec3(x, how_.aside, z), turn_}; }

  Cut how_;
  Eigen::Quaterniond turn_;
  TissueCells cells_;
  std::vector<Vec3> points_ = {{0, 0, 0.6}, {0, 0, -0.6}};  // never leaves the block sideways
  TissueStep step_;
  double z = 0, held_ = 0;

 public:
  ElasticTissue tissue;
  double x = 0;                                       // of the edge, m
  double work = 0, took = 0, expected = 0, lost = 0;  // J
  std::int64_t severed = 0;
};

Outcome through(const Cut& how) {
  Guillotine block(how);
  const double full = (how.energy > 0 ? how.energy : 1) * block.width(), half = how.length / 2;
  Outcome outcome;
  int frames = 0;
  while (block.x < half - 0.015) {
    const Vec3 force = block.advance(how.speed);
    outcome.largest = std::max(outcome.largest, -force.x() / full);
    const double front = block.front();
    if (front < -half + how.from * how.length || front > -half + how.to * how.length) continue;
    outcome.force -= force.x() / full;
    outcome.along -= force.z() / full;
    ++frames;
  }
  if (frames > 0) outcome.force /= frames, outcome.along /= frames;
  outcome.work = block.work;
  outcome.cut = block.took;
  outcome.expected = block.expected;
  outcome.unexplained = block.lost / block.work;
  outcome.severed = block.severed;
  outcome.sum = block.displacements();
  return outcome;
}

}  // namespace

TEST_CASE("a straight push takes J w, on any cells, at any speed, turned in the lattice") {
  test::Figures figures("cut force");
  const auto check = [&](const Cut& how, double allowed) {
    const Outcome cut = through(how);
    const std::string name = fmt::format("cells of {} mm, turned {}, {} mm/s: F / (J w)",
                                         1e3 * how.spacing, how.degrees, 1e3 * how.speed);
    CAPTURE(name);
    CHECK(figures.add(name, cut.force, 1, allowed) < allowed);
  };
  for (const double mm : {8.0, 5.0, 2.5})
    for (const double degrees : {0.0, 15.0, 30.0, 45.0})
      check({.spacing = 1e-3 * mm, .degrees = degrees}, degrees < 45 ? 0.05 : 0.1);
  for (const double speed : {0.002, 0.1}) check({.speed = speed}, 0.05);
  for (const double speed : {0.005, 0.1}) check({.spacing = 0.008, .speed = speed}, 0.05);
}

TEST_CASE("slicing takes less: J w / (1 + xi^2) forwards, xi times that along the edge") {
  test::Figures figures("slicing");
  for (const double mm : {8.0, 5.0})
    for (const double xi : {0.5, 1.0, 2.0, 3.0}) {
      // Until the force along a long edge is steady, the front has to go some way. In a narrow
      // block the edge meets less tissue than its width: it drags the sides of the block along.
      const Outcome cut = through(
          {.spacing = 1e-3 * mm, .xi = xi, .length = 0.16, .width = 0.04, .from = 0.4, .to = 0.75});
      const std::string name = fmt::format("cells of {} mm, xi {}: ", mm, xi);
      CAPTURE(name);
      const double less = 1 / (1 + xi * xi);
      CHECK(figures.add(name + "forwards", cut.force, less, 0.1) < 0.1);
      CHECK(figures.add(name + "along the edge", cut.along, xi * less, 0.1) < 0.1);
    }
}

TEST_CASE("the hand's work goes into the cut and the tissue, and the cut takes J per area") {
  test::Figures figures("cut ledger");
  for (const auto& [mm, allowed] : {std::pair(8.0, 0.08), {5.0, 0.05}, {2.5, 0.02}}) {
    const Outcome cut = through({.spacing = 1e-3 * mm});
    CAPTURE(mm);
    CHECK(figures.addError(fmt::format("cells of {} mm: lost where the faces meet, share", mm),
                           std::abs(cut.unexplained), allowed) < allowed);
    const Outcome apart = through({.spacing = 1e-3 * mm, .touch = false});
    CHECK(figures.addError(fmt::format("cells of {} mm: lost elsewhere, share", mm),
                           std::abs(apart.unexplained), 0.02) < 0.02);
    CHECK(figures.add(fmt::format("cells of {} mm: work of cutting / (J A)", mm),
                      cut.cut / cut.expected, 1, 0.1) < 0.1);
  }
}

TEST_CASE("an open cut is entered without force, and its end resists as before") {
  Guillotine block({});
  const double full = kJ * block.width();
  while (block.front() < 0) block.advance(0.02);
  while (block.x > -0.045) block.advance(-0.1);
  for (int i = 0; i < 20; ++i) block.advance(0);
  const std::int64_t severed = block.severed;
  double most = 0;
  while (block.x < -0.012) most = std::max(most, block.advance(0.05).norm());
  CHECK(most < 0.1 * full);
  CHECK(block.severed - severed < 20);
  while (block.x < 0.02) most = std::max(most, block.advance(0.02).norm());
  CHECK(most > 0.9 * full);
  CHECK(most < 1.1 * full);
}

TEST_CASE("tissue without a cut energy is cut without force, where the edge passes") {
  const Outcome cut = through({.energy = 0});
  CHECK(cut.largest < 1e-3);  // N
  CHECK(cut.severed > 300);
}

TEST_CASE("a capsule resists where it is entered") {
  const double perSkin = 0.1;
  Guillotine block({.perSkin = perSkin});
  double most = 0;
  while (block.x < 0.03) most = std::max(most, -block.advance(0.02).x());
  CHECK(most > 1.3 * kJ * block.width());
  CHECK(most < 1.1 * (kJ + perSkin / 0.002) * block.width());  // spread over 2 mm
}

TEST_CASE("a cut is the same, to the bit, on one thread and on four") {
  const Outcome one = through({.spacing = 0.008, .degrees = 30}),
                four = through({.spacing = 0.008, .degrees = 30, .threads = 4});
  CHECK(one.severed == four.severed);
  CHECK(one.sum == four.sum);
  CHECK(one.work == four.work);
}

TEST_CASE("in crushed tissue, too, an edge cuts only what is near it") {
  constexpr double kSpacing = 0.005;
  Random random(7);
  double farthest = 0;  // distance of a cut bond from the edge, world, m
  std::int64_t severed = 0;
  for (int trial = 0; trial < 30; ++trial) {
    ElasticTissue tissue(test::solidBlock({24, 12, 12}, kSpacing, test::plainLiver()),
                         test::weightless());
    const Vec3 middle = tissue.lattice().box().centre();
    const double flat = random.uniform(0.06, 0.3);
    test::forEachCell(tissue, [&](std::int64_t c, const Vec3i& at) {
      const Vec3 x = tissue.lattice().centre(at) - middle;
      const Vec3 noise(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
      tissue.setDisplacement(
          c, Vec3((flat - 1) * x.x(), 0.3 * x.y(), 0.3 * x.z()) + 0.1 * kSpacing * noise);
      tissue.hold(c, kHeldAll);
    });
    const Vec3 tip = middle + Vec3(random.uniform(-0.01, 0.01), random.uniform(-0.02, 0.02),
                                   random.uniform(-0.02, 0.02));
    const Vec3 along(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    const std::vector<Vec3> points{Vec3::Zero(), 0.015 * along.normalized()};
    const Vec3 normal = along.cross(Vec3::UnitX()).normalized();
    const Vec3 way = along.normalized().cross(normal);
    TissueStep step;
    for (int frame = 0; frame < 8; ++frame) {
      Pose from, to;
      from.position = tip + 0.003 * frame * way, to.position = tip + 0.003 * (frame + 1) * way;
      const CuttingEdge edge{points, normal, from, to};
      Obstacle tool;
      tool.tool = 0;
      tool.edges = {&edge, 1};
      moveTissue(tissue, {&tool, 1}, kFrame, step);
      for (const TissueCut& one : step.cuts)
        for (const TissueBond& bond : crossedBonds(tissue, tissue.lattice(), one.blade)) {
          const Vec3 at = tissue.lattice().centre(tissue.lattice().cell(bond.cell)) +
                          tissue.displacement(bond.cell);
          const Vec3 off = at - to.position;
          const double share = std::clamp(off.dot(along.normalized()), 0.0, 0.015);
          farthest = std::max(farthest, (off - share * along.normalized()).norm());
          tissue.sever(bond.cell, bond.direction);
          ++severed;
        }
      tissue.settle();
    }
  }
  CHECK(severed > 1000);
  CHECK(farthest < 4 * kSpacing);
}
