#include "organ/organ.h"

#include "organ/apply_edits.h"

#include <doctest/doctest.h>

#include <cmath>

#include "base/error.h"
#include "base/random.h"
#include "geometry/measures.h"
#include "geometry/primitives.h"
#include "geometry/topology.h"
#include "organ/discretize.h"
#include "organ/parts/bodies.h"
#include "support/block_organ.h"

using namespace resect;

namespace {

Organ sphereOrgan(double radius, double s) {
  const TriangleMesh mesh = sphereMesh({0, 0.1, 0}, radius, 48);
  return makeOrgan(discretize(mesh, latticeForSpacing(bounds(mesh), s), {}), {});
}

}  // namespace

TEST_CASE("the volumes of all particles add up to the organ's volume") {
  const Organ organ = sphereOrgan(0.04, 0.005);
  double sum = 0;
  for (std::size_t i = 0; i < organ.alive.size(); ++i)
    if (organ.alive[i]) sum += particleVolume(organ.rest, std::int64_t(i));
  CHECK(std::abs(sum / organ.volume() - 1) < 1e-12);
}

TEST_CASE(
    "removing every particle leaves nothing: no tissue, no surface, all of it in the ledger") {
  Organ organ = sphereOrgan(0.03, 0.005);
  const double all = organ.volume();
  const std::int64_t particles = organ.particles;
  for (std::size_t i = 0; i < organ.alive.size(); ++i)
    if (organ.alive[i]) removeParticle(organ, std::int64_t(i));
  updateSurface(organ, updateField(organ));
  CHECK(organ.removed == particles);
  CHECK(organ.particles == 0);
  CHECK(std::abs(organ.removedVolume / all - 1) < 1e-12);
  CHECK(std::abs(organ.volume()) < 1e-12 * all);
  CHECK(organ.surface.mesh().triangles.empty());
  double left = 0;
  for (std::int64_t i = 0; i < organ.rest.lattice.cellCount(); ++i)
    left += organ.field.cellValue(i);
  CHECK(left == 0);
}

TEST_CASE("removing a particle twice counts once") {
  OperatedOrgan operated = operatedOrgan("ball", sphereOrgan(0.03, 0.005));
  std::int64_t cell = 0;
  while (!operated.organ.alive[std::size_t(cell)]) ++cell;
  const TissueEdit edit{0, 0, RemoveCell{cell}};
  std::vector<std::int64_t> removed;
  CHECK(applyEdits(operated, 0, std::vector{edit, edit}, removed).removed == 1);
  CHECK(applyEdits(operated, 0, std::vector{edit}, removed).removed == 0);
  CHECK(removed == std::vector{cell});
}

TEST_CASE("an organ smaller than a cell and settings out of range are refused in a sentence") {
  const Discretization empty = test::fill({3, 3, 3}, 0.005, [](const Vec3i&) { return 10.0; });
  CHECK_THROWS_AS(makeOrgan(empty, {}), Error);
  OrganSettings settings;
  settings.iso = 100;
  CHECK_THROWS_AS(makeOrgan(test::ball(8), settings), Error);
  settings = {};
  settings.refine = 0;
  CHECK_THROWS_AS(makeOrgan(test::ball(8), settings), Error);
}

TEST_CASE("a block cut in two has two bodies whose volumes add up, each closed") {
  Organ organ = makeOrgan(test::fullBlock({24, 12, 12}), {});
  const double before = volume(organ.surface.mesh());
  for (std::int64_t i = 0; i < organ.rest.lattice.cellCount(); ++i)
    if (organ.rest.lattice.cell(i).x() == 9) removeParticle(organ, i);
  updateSurface(organ, updateField(organ));
  const auto pieces = bodies(organ.surface.mesh());
  REQUIRE(pieces.size() == 2);
  for (const TriangleMesh& piece : pieces) {
    CHECK(topology(piece).closed());
    CHECK(topology(piece).oriented());
  }
  CHECK(volume(pieces[0]) > volume(pieces[1]));
  const double parted = volume(pieces[0]) + volume(pieces[1]);
  // The rest is the layer taken out, to 1 % of the whole: edges are rounded by the kernel.
  CHECK(std::abs((parted + organ.removedVolume) / before - 1) < 0.01);
}

TEST_CASE("a cavity stays with the body round it") {
  TriangleMesh mesh = boxMesh({{0, 0, 0}, {10, 10, 10}});
  TriangleMesh cavity = boxMesh({{2, 2, 2}, {4, 4, 4}});
  flip(cavity);
  append(mesh, cavity);
  append(mesh, boxMesh({{20, 0, 0}, {21, 1, 1}}));
  const auto pieces = bodies(mesh);
  REQUIRE(pieces.size() == 2);
  CHECK(volume(pieces[0]) == doctest::Approx(1000 - 8));
  CHECK(volume(pieces[1]) == doctest::Approx(1));
  CHECK(bodies({}).empty());
}
