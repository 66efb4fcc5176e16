#include "tissue/elastic/elastic_tissue.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/parallel.h"
#include "base/state/saved_state.h"
#include "base/state/state_hash.h"
#include "support/references/reference_tissue.h"
#include "support/references/relax.h"
#include "support/references/wide_kernel.h"
#include "support/tissue_blocks.h"

using namespace resect;
using test::material;
using test::solidBlock;

namespace {

// A block with holes, two materials, and cells hanging by few bonds.
TissueCells raggedBlock(std::uint64_t seed) {
  TissueCells cells = solidBlock({21, 9, 8}, 0.004, material(5000, 0.45));
  cells.materials.push_back(material(20000, 0.4, 1100));
  cells.material.assign(cells.solid.size(), 0);
  Random random(seed);
  for (std::size_t c = 0; c < cells.solid.size(); ++c) {
    cells.solid[c] = random.uniform() > 0.15;
    cells.material[c] = cells.lattice.cell(std::int64_t(c)).x() > 13;
  }
  return cells;
}

// The same smooth and rough displacement for both.
Vec3 wobble(const Vec3i& c, Random& random) {
  const Vec3 x = 0.004 * c.cast<double>();
  return Vec3(0.002 * std::sin(60 * x.y()), 0.003 * std::sin(40 * x.x()), 0.1 * x.x() * x.z()) +
         0.0003 * Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
}

std::uint64_t hashOf(const ElasticTissue& tissue) {
  StateHash hash;
  for (int a = 0; a < 3; ++a) {
    hash.addSpan(std::span<const float>(tissue.state().u[a]));
    hash.addSpan(std::span<const float>(tissue.state().v[a]));
  }
  return hash.value();
}

}  // namespace

TEST_CASE(
    "forces equal those of the neighbour-list reference in double precision, in ragged cut "
    "blocks of two materials too") {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const TissueCells cells = raggedBlock(seed);
    TissueSettings settings = test::weightless();
    ElasticTissue tissue(cells, settings);
    test::ReferenceTissue<double> reference(cells, settings.penalty);
    const auto side = [&](const Vec3i& c) { return 3 * c.x() + 2 * c.y() - c.z() > 35; };
    test::severBetween(tissue, side);
    reference.sever([&](int i, int j) {
      return side(cells.lattice.cell(reference.cellOf[i])) !=
             side(cells.lattice.cell(reference.cellOf[j]));
    });
    tissue.evaluateForces();  // at rest, so that threads are born at their rest lengths
    Random random(seed);
    for (std::size_t i = 0; i < reference.u.size(); ++i) {
      const std::int64_t c = reference.cellOf[i];
      tissue.setDisplacement(c, wobble(cells.lattice.cell(c), random));
      reference.u[i] = tissue.displacement(c);
    }
    tissue.evaluateForces();
    const auto forces = reference.forces();
    double largest = 0, worst = 0;
    int degenerate = 0;
    for (std::size_t i = 0; i < forces.size(); ++i) {
      largest = std::max(largest, forces[i].norm());
      worst = std::max(worst, (tissue.elasticForce(reference.cellOf[i]) - forces[i]).norm());
      degenerate += !reference.deforms[i];
    }
    CHECK(degenerate > 0);  // the path of cells without gradient is exercised
    CHECK(worst < 3e-6 * largest);
    CHECK(tissue.energy().elastic == doctest::Approx(reference.energy()).epsilon(1e-6));
  }
}

TEST_CASE("motion over a hundred substeps follows the reference") {
  const TissueCells cells = raggedBlock(4);
  TissueSettings settings;
  ElasticTissue tissue(cells, settings);
  test::ReferenceTissue<double> reference(cells, settings.penalty);
  const double dt = 0.9 * tissue.longestSubstep();
  for (int i = 0; i < 100; ++i) {
    CHECK(tissue.advance(dt).substeps == 1);
    reference.step(dt, settings.damping, settings.gravity);
  }
  double furthest = 0, worst = 0;
  for (std::size_t i = 0; i < reference.u.size(); ++i) {
    furthest = std::max(furthest, reference.u[i].norm());
    worst = std::max(worst, (tissue.displacement(reference.cellOf[i]) - reference.u[i]).norm());
  }
  CHECK(furthest > 0.001);
  CHECK(worst < 1e-5 * furthest);
}

TEST_CASE("every instruction set and every number of threads gives the same bits") {
  const TissueCells cells = raggedBlock(5);
  const auto run = [&](const ElasticKernel& kernel, int threads) {
    TissueSettings settings;
    settings.threads = threads;
    const ThreadLimit limit(threads);
    ElasticTissue tissue(cells, settings);
    tissue.useKernel(kernel);
    for (int i = 0; i < 12; ++i) {
      if (i == 4) test::severBetween(tissue, [](const Vec3i& c) { return c.x() + c.y() > 14; });
      if (i == 8) tissue.remove(cells.lattice.index({4, 4, 4}));
      tissue.advance(1.0 / 60);
    }
    return hashOf(tissue);
  };
  const std::uint64_t first = run(*kernelNamed("baseline"), 1);
  CHECK(run(test::wideKernel(), 1) == first);
  for (const char* name : {"avx2", "avx512"})
    if (const ElasticKernel* kernel = kernelNamed(name)) {
      CHECK(run(*kernel, 1) == first);
    } else {
      MESSAGE("skipped: this machine has no " << std::string(name));
    }
  for (const int threads : {1, 2, 3}) CHECK(run(fastestKernel(), threads) == first);
}

TEST_CASE("cells are placed many at a time as one by one, whatever the instruction set") {
  ElasticTissue tissue(raggedBlock(6), {});
  test::severBetween(tissue, [](const Vec3i& c) { return c.x() + c.y() > 14; });
  Random random(6);
  std::vector<std::int64_t> cells;
  test::forEachCell(tissue, [&](std::int64_t c, const Vec3i& at) {
    cells.push_back(c);
    tissue.setDisplacement(c, wobble(at, random));
  });
  for (std::size_t i = 0; i < cells.size() / 4; ++i)  // some stand alone in the list
    std::swap(cells[i], cells[std::size_t(random.below(int(cells.size())))]);
  std::vector<CellPlacement> first;
  for (const ElasticKernel* kernel :
       {kernelNamed("baseline"), &test::wideKernel(), kernelNamed("avx2"), kernelNamed("avx512")}) {
    if (!kernel) continue;
    tissue.useKernel(*kernel);
    std::vector<CellPlacement> places(cells.size());
    tissue.place(cells, places);
    if (first.empty()) first = places;
    double worst = 0;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      REQUIRE(places[i].displacement == first[i].displacement);
      REQUIRE(places[i].gradient == first[i].gradient);
      REQUIRE(places[i].displacement.cast<double>() == tissue.displacement(cells[i]));
      const Mat3 f = Mat3::Identity() + places[i].gradient.cast<double>();
      worst = std::max(worst, (f - tissue.deformation(cells[i])).norm());
    }
    CHECK(worst < 1e-5);
  }
  double most = 0;
  for (const CellPlacement& place : first) most = std::max(most, double(place.gradient.norm()));
  CHECK(most > 0.01);
}

TEST_CASE("cells without a gradient, isolated cells and lone pairs fall freely and stay finite") {
  TissueCells cells = solidBlock({12, 3, 3}, 0.005, liverTissue());
  std::fill(cells.solid.begin(), cells.solid.end(), 0);
  for (const Vec3i& c : {Vec3i(1, 1, 1), Vec3i(5, 1, 1), Vec3i(6, 1, 1), Vec3i(9, 0, 0),
                         Vec3i(10, 1, 0), Vec3i(11, 1, 0)})
    cells.solid[cells.lattice.index(c)] = 1;
  ElasticTissue tissue(cells, {});
  for (int i = 0; i < 6; ++i) CHECK(tissue.advance(1.0 / 60).calm);
  test::forEachCell(tissue, [&](std::int64_t c, const Vec3i&) {
    CHECK(tissue.velocity(c).y() == doctest::Approx(-0.981));
    CHECK((tissue.deformation(c) - Mat3::Identity()).norm() < 1e-6);
  });
}

TEST_CASE("a string and a sheet of single cells hold together, and turn freely") {
  TissueCells cells = solidBlock({10, 1, 6}, 0.005, liverTissue());
  for (std::int64_t c = 0; c < 60; ++c)
    cells.solid[c] = cells.lattice.cell(c).x() < 5 || cells.lattice.cell(c).z() == 2;
  TissueSettings settings;
  settings.drag = 3;
  ElasticTissue tissue(cells, settings);
  for (int z = 0; z < 6; ++z) tissue.hold(cells.lattice.index({0, 0, z}), kHeldAll);
  for (int i = 0; i < 180; ++i) CHECK(tissue.advance(1.0 / 60).calm);
  // It hangs straight down from the held row, a little stretched by its weight.
  const Vec3 end =
      cells.lattice.centre({9, 0, 2}) + tissue.displacement(cells.lattice.index({9, 0, 2}));
  CHECK(end.y() < -0.035);
  CHECK(end.y() > -0.06);
  CHECK(std::abs(end.x()) < 0.02);
}

TEST_CASE("a held cell moves as it is told, a loaded one feels its force, a freed one falls") {
  TissueCells cells = solidBlock({3, 1, 1}, 0.005, liverTissue());
  cells.solid[1] = 0;
  ElasticTissue tissue(cells, {});
  tissue.hold(0, kHeldY, {0, 0.02, 0});
  tissue.setLoad(2, {0, 2 * 9.81 * tissue.mass(2), 0});
  tissue.advance(0.1);
  CHECK(tissue.displacement(0).y() == doctest::Approx(0.002));
  CHECK(tissue.velocity(2).y() == doctest::Approx(0.981).epsilon(1e-4));
  tissue.hold(0, 0);
  tissue.advance(0.1);
  CHECK(tissue.velocity(0).y() == doctest::Approx(0.02 - 0.981).epsilon(1e-4));
}

TEST_CASE("a state that is not a number is put back the same frame, and a lasting one is stopped") {
  TissueCells cells = solidBlock({8, 4, 4}, 0.005, liverTissue());
  ElasticTissue tissue(cells, {});
  tissue.advance(1.0 / 60);
  const Vec3 before = tissue.displacement(5);
  tissue.setLoad(5, Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
  const auto advance = tissue.advance(1.0 / 60);
  CHECK(!advance.calm);
  CHECK(advance.retries == 6);
  CHECK(tissue.displacement(5) == before);
  tissue.setLoad(5, Vec3::Zero());
  CHECK(tissue.advance(1.0 / 60).calm);
  CHECK(tissue.displacement(5).allFinite());
}

TEST_CASE("a blow that is too much for the substep is met with shorter ones") {
  TissueCells cells = solidBlock({8, 4, 4}, 0.005, liverTissue());
  ElasticTissue tissue(cells, test::weightless());
  tissue.setVelocity(cells.lattice.index({4, 2, 2}), {200, 0, 0});
  const auto advance = tissue.advance(1.0 / 60);
  CHECK(advance.retries > 0);
  CHECK(advance.calm);
}

TEST_CASE("unusable settings are refused with a sentence") {
  TissueCells cells = solidBlock({2, 2, 2}, 0.005, liverTissue());
  cells.lattice.spacing.x() = 0.006;
  CHECK_THROWS_WITH_AS(ElasticTissue(cells, {}), doctest::Contains("only cubic cells can deform"),
                       Error);
  cells.lattice.spacing.x() = 0.005;
  cells.materials[0].poisson = 0.5;
  CHECK_THROWS_WITH_AS(ElasticTissue(cells, {}), doctest::Contains("poisson"), Error);
  cells.materials[0].poisson = 0.4;
  TissueSettings settings;
  settings.damping = 0.7;
  CHECK_THROWS_WITH_AS(ElasticTissue(cells, settings), doctest::Contains("damping"), Error);
  cells.solid.assign(8, 0);
  CHECK_THROWS_WITH_AS(ElasticTissue(cells, {}), doctest::Contains("no solid cell"), Error);
}

TEST_CASE("where a pin ends between two cells, tissue is held as its part of them says") {
  // A bar that sticks out of the pinned region bends by its weight.
  const auto sag = [](double end) {  // of the region, in cells from the bar's end
    const double s = 0.008;
    TissueSettings settings;
    settings.gravity *= 0.1;
    ElasticTissue tissue(solidBlock({20, 5, 5}, s, test::plainLiver()), settings);
    TissueAttachment pin;
    pin.shape = Region::Shape::Box;
    pin.box = {Vec3::Constant(-1), Vec3(s * (end - 0.5), 1, 1)};
    CHECK(tissue.attach(pin) == 25 * int(std::ceil(end)));
    test::relax(tissue, 1e-6);
    return -tissue.displacement(tissue.lattice().index({19, 2, 2})).y();
  };
  const double four = sag(4), between = sag(4.5), five = sag(5);
  CHECK(four > 1.15 * five);
  CHECK(between == doctest::Approx(0.5 * (four + five)).epsilon(0.05));
  CHECK(sag(4.25) == doctest::Approx(0.75 * four + 0.25 * five).epsilon(0.05));
}

TEST_CASE("a state restored into tissue of other materials goes on with the same bits") {
  const TissueCells block = solidBlock({9, 6, 6}, 0.005, material(5000, 0.3));
  const auto withPart = [&](ElasticTissue& tissue, int from, double young) {
    test::forEachCell(tissue, [&](std::int64_t c, const Vec3i& at) {
      if (at.x() == 0) tissue.hold(c, kHeldAll);
      if (at.x() >= from) tissue.setMaterial(c, material(young, 0.3));
    });
    for (int frame = 0; frame < 5; ++frame) tissue.advance(1.0 / 60);
  };
  ElasticTissue tissue(block, {}), other(block, {});
  withPart(tissue, 5, 20000), withPart(other, 3, 60000);  // both are the tissue's material 1
  other.beginRestore();
  loadState(other, saveState(tissue, 1));
  other.endRestore({});
  for (ElasticTissue* one : {&tissue, &other})
    for (int frame = 0; frame < 5; ++frame) one->advance(1.0 / 60);
  CHECK_FALSE(firstDifference(saveState(tissue, 1), saveState(other, 1)).has_value());
}
