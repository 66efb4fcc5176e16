// Boundary cells keep the organ's volume, and follow their particles through edits.
#include <doctest/doctest.h>

#include "base/error.h"
#include "base/random.h"
#include "geometry/measures.h"
#include "geometry/primitives.h"
#include "organ/discretize.h"
#include "organ/tissue_cells.h"
#include "support/tissue_blocks.h"
#include "tissue/elastic/boundary_cells.h"

using namespace resect;

namespace {

constexpr double kSide = 0.005;  // of a cell, m

// A ring that lies oblique in the lattice.
Discretization obliqueRing() {
  const TriangleMesh mesh =
      transformed(torusMesh({0, 0, 0}, 0.03, 0.012),
                  {Vec3(0.0011, 0.0007, 0),
                   Eigen::Quaterniond(Eigen::AngleAxisd(0.6, Vec3(1, 2, 3).normalized()))});
  return discretize(mesh, latticeForSpacing(bounds(mesh).padded(kSide), kSide));
}

// Whether boundary cells are as their particles are now.
void checkBoundary(const ElasticTissue& tissue) {
  const ElasticState& s = tissue.state();
  int wrong = 0;
  for (std::int64_t c = 0; c < tissue.lattice().cellCount(); ++c) {
    const std::int32_t i = s.box.fromLattice(c);
    if (!s.solid[i] || !s.owner[i]) continue;
    wrong += !s.solid[ownerOf(s, i)] || s.kappa[i] == 0;
    for (int d = 0; d < kDirections; ++d)
      if (s.bonds[i] >> d & 1) wrong += !connected(s, i, i + s.box.step[d]);
  }
  CHECK(wrong == 0);
}

std::int64_t boundaryCells(const ElasticTissue& tissue) {
  std::int64_t count = 0, particles = 0;
  test::forEachSolid(tissue, [&](std::int64_t, const Vec3i&) { ++count; });
  test::forEachCell(tissue, [&](std::int64_t, const Vec3i&) { ++particles; });
  return count - particles;
}

}  // namespace

TEST_CASE("the shares of stress are the organ's volume, its middle and its second moments") {
  const Discretization ring = obliqueRing();
  const TissueCells cells = tissueCells(ring, liverTissue());
  const std::vector<float> shares = stressShares(cells);
  double volume = 0, stressed = 0;  // in cells
  Vec3 middle = Vec3::Zero(), stressedMiddle = Vec3::Zero();
  Mat3 second = Mat3::Zero();
  for (std::int64_t c = 0; c < ring.lattice.cellCount(); ++c) {
    const Vec3 at = ring.lattice.centre(ring.lattice.cell(c));
    const double share = double(cells.share[std::size_t(c)]),
                 stress = double(shares[std::size_t(c)]);
    if (stress > 0) CHECK(holdsTissue(cells, c));
    volume += share;
    stressed += stress;
    middle += share * at;
    stressedMiddle += stress * at;
    second += stress * at * at.transpose();
  }
  CHECK(stressed == doctest::Approx(volume).epsilon(0.01));  // but for cells out of reach
  CHECK((stressedMiddle / stressed - middle / volume).norm() < 0.02 * kSide);
  // Of a torus with radii R and r, about its middle: R^2 + r^2 per volume.
  const Vec3 about = stressedMiddle / stressed;
  const double polar = (second / stressed - about * about.transpose()).trace();
  CHECK(polar == doctest::Approx(0.03 * 0.03 + 0.012 * 0.012).epsilon(0.03));
}

TEST_CASE("boundary cells go with their particles, and hold no parts together that are cut apart") {
  for (const std::uint64_t seed : {1, 2, 3}) {
    ElasticTissue tissue(tissueCells(obliqueRing(), liverTissue()), test::weightless());
    REQUIRE(boundaryCells(tissue) > 200);
    checkBoundary(tissue);
    Random random(seed);
    for (int round = 0; round < 30; ++round) {
      const Vec3 normal =
          Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)).normalized();
      const double level = random.uniform(-0.03, 0.03);
      const auto beyond = [&](const Vec3i& at) {
        return normal.dot(tissue.lattice().centre(at)) > level;
      };
      if (round % 3 == 2) {  // a lump is taken
        const Vec3 from = 0.03 * normal;
        std::vector<std::int64_t> taken;
        test::forEachCell(tissue, [&](std::int64_t c, const Vec3i& at) {
          if ((tissue.lattice().centre(at) - from).norm() < 0.012) taken.push_back(c);
        });
        for (const std::int64_t c : taken) tissue.remove(c);
      } else {
        test::severBetween(tissue, beyond);
      }
      tissue.settle();
      checkBoundary(tissue);
      if (round % 3 == 2) continue;
      // No bond of any cell leads from one side to the other.
      const ElasticState& s = tissue.state();
      int across = 0;
      test::forEachSolid(tissue, [&](std::int64_t c, const Vec3i&) {
        const std::int32_t i = s.box.fromLattice(c);
        for (int d = 0; d < kDirections; ++d)
          if (s.bonds[i] >> d & 1)
            across += beyond(s.box.cell(ownerOf(s, i))) !=
                      beyond(s.box.cell(ownerOf(s, i + s.box.step[d])));
      });
      CHECK(across == 0);
    }
  }
}

TEST_CASE("boundary cells that fit no particles are refused") {
  const TissueCells good = tissueCells(obliqueRing(), liverTissue());
  const auto refused = [&](auto spoil) {
    TissueCells cells = good;
    spoil(cells);
    CHECK_THROWS_AS(ElasticTissue(cells, test::weightless()), Error);
  };
  std::size_t outside = 0, particle = 0;
  while (!good.owner[outside]) ++outside;
  while (!good.solid[particle]) ++particle;
  refused([](TissueCells& c) { c.share.pop_back(); });
  refused([](TissueCells& c) { c.share.clear(); });
  refused([&](TissueCells& c) { c.share[outside] = 1.5f; });
  refused([&](TissueCells& c) { c.owner[outside] = kDirections + 1; });
  refused([&](TissueCells& c) { c.owner[particle] = 1; });
}
