// Fitted colour values reproduce a body's surface better than shares.
#include "organ/fit_surface.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "base/parallel.h"
#include "geometry/measures.h"
#include "geometry/primitives.h"
#include "geometry/topology.h"
#include "organ/discretize.h"
#include "organ/organ.h"
#include "sph/colour_field.h"
#include "sph/colour_values.h"
#include "support/references/plain_fit.h"
#include "support/surface_look.h"

using namespace resect;

namespace {

constexpr double kRadius = 0.0615, kCell = 0.005;

TriangleMesh body() { return sphereMesh({0.0013, -0.0027, 0.0041}, kRadius, 96); }

Discretization shares() {
  const TriangleMesh mesh = body();
  return discretize(mesh, latticeForSpacing(bounds(mesh), kCell));
}

struct Misfit {
  double distance = 0;  // rms, m, of the surface's vertices from the ball
  double angle = 0;     // mean, degrees, of its normals
  double volume = 0;    // relative
};

Misfit misfit(const Discretization& cells, int refine = 2) {
  Organ organ = makeOrgan(cells, {.refine = refine});
  const SurfaceTracker::Compact surface = test::withLook(organ.surface, organ.field);
  Misfit result;
  for (std::size_t i = 0; i < surface.mesh.points.size(); ++i) {
    const Vec3 out = surface.mesh.points[i] - Vec3(0.0013, -0.0027, 0.0041);
    result.distance += std::pow(out.norm() - kRadius, 2);
    const double cosine = out.normalized().dot(surface.normals[i].cast<double>());
    result.angle += std::acos(std::min(1.0, cosine)) * 180 / std::numbers::pi;
  }
  const double count = double(surface.mesh.points.size());
  result.distance = std::sqrt(result.distance / count);
  result.angle /= count;
  result.volume = volume(surface.mesh) / volume(body()) - 1;
  return result;
}

}  // namespace

TEST_CASE(
    "fitted values bring the surface of a ball to half its distance, normals and volume too") {
  Discretization cells = shares();
  const Misfit before = misfit(cells);
  fitSurface(body(), cells);
  const Misfit after = misfit(cells);
  const double coarse = misfit(cells, 1).angle;
  MESSAGE("rms distance ", 1e3 * before.distance, " -> ", 1e3 * after.distance, " mm, normals ",
          before.angle, " -> ", after.angle, " degrees (", coarse,
          " with one node a cell), volume ", 100 * before.volume, " -> ", 100 * after.volume, " %");
  CHECK(after.distance < 0.55 * before.distance);
  CHECK(after.angle < 0.7 * before.angle);
  CHECK(after.angle < 1.7);  // 2.5 with plain differences
  CHECK(coarse < 1.4);
  CHECK(std::abs(after.volume) < 0.25 * std::abs(before.volume));
}

TEST_CASE("only cells that the surface passes through change, and the volumes still add up") {
  const Discretization before = shares();
  Discretization after = before;
  fitSurface(body(), after);
  CHECK(after.inside == before.inside);
  for (std::size_t i = 0; i < before.value.size(); ++i) {
    if (before.value[i] == 0 || before.value[i] == 100) CHECK(after.value[i] == before.value[i]);
    CHECK((after.value[i] > 0) == (before.value[i] > 0));
    CHECK((after.value[i] < 100) == (before.value[i] < 100));
  }
  CHECK(after.volume() == doctest::Approx(before.volume()).epsilon(1e-12));
}

TEST_CASE("shares and fitted values are whole levels, so the field of both holds them as bytes") {
  const Discretization before = shares();
  Discretization after = before, numbers = before;
  fitSurface(body(), after);
  CHECK(after.value != before.value);
  CHECK(before.value.areLevels());
  CHECK(after.value.areLevels());
  numbers.value.set(0, 33.3f);
  const std::size_t asNumbers = ColourField(numbers, 1).bytes();
  CHECK(ColourField(before, 1).bytes() + 3 * before.value.size() < asNumbers);
  CHECK(ColourField(after, 1).bytes() + 3 * before.value.size() < asNumbers);
}

TEST_CASE("a box that fits its lattice is left as it is") {
  const Aabb box{{0, 0, 0}, {0.05, 0.03, 0.02}};
  Discretization cells = discretize(boxMesh(box), latticeForSpacing(box, 0.01));
  const ColourValues before = cells.value;
  fitSurface(boxMesh(box), cells);
  CHECK(cells.value == before);
}

TEST_CASE("fitting gives the same bits at 1, 2 and 3 threads") {
  const Discretization start = shares();
  ColourValues first;
  for (const int threads : {1, 2, 3}) {
    const ThreadLimit limit(threads);
    Discretization cells = start;
    fitSurface(body(), cells);
    if (first.size() == 0) first = cells.value;
    CHECK(cells.value == first);
  }
}

TEST_CASE("fitted values are those found with every weight evaluated where it is needed") {
  const TriangleMesh ball = sphereMesh({0.0013, -0.0027, 0.0041}, 0.0215, 24);
  Discretization cells = discretize(ball, latticeForSpacing(bounds(ball), kCell));
  const std::vector<float> expected = test::plainFit(ball, cells);
  fitSurface(ball, cells);
  for (std::size_t i = 0; i < expected.size(); ++i) CHECK(cells.value[i] == expected[i]);
}
