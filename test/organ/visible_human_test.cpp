// Accuracy of the surface for a real liver: the Visible Human's, if it is here.

#include <doctest/doctest.h>

#include <cmath>

#include "anatomy/visible_human.h"
#include "base/random.h"
#include "geometry/measures.h"
#include "geometry/primitives.h"
#include "organ/discretize.h"
#include "organ/fit_surface.h"
#include "support/references/mesh_reference.h"
#include "support/references/nearest_triangle.h"
#include "support/surface_look.h"
#include "surface/surface_tracker.h"

using namespace resect;

namespace {

struct Likeness {
  double volumeError;  // share
  test::Deviation deviation;
};

Likeness likeness(const Discretization& cells, const TriangleMesh& original) {
  const ColourField field(cells, 2);
  const auto surface = test::withLook(field, 50);
  return {volume(surface.mesh) / volume(original) - 1,
          test::deviation(surface.mesh, surface.normals, original)};
}

void report(const std::string& values, const Likeness& l) {
  MESSAGE(values << " values: volume " << 100 * l.volumeError << " %, distance "
                 << 1e3 * l.deviation.distance << " mm, triangles' normals "
                 << l.deviation.faceAngle << ", vertex normals " << l.deviation.shadingAngle
                 << " degrees");
}

}  // namespace

TEST_CASE("the nearest triangle found on a grid is the one that looking at all of them finds") {
  const TriangleMesh torus = torusMesh({0, 0, 0}, 0.05, 0.02, 20, 10);
  const test::NearestTriangle nearest(torus, 0.01);
  Random random(8);
  for (int i = 0; i < 200; ++i) {
    const Vec3 p(random.uniform(-0.15, 0.15), random.uniform(-0.15, 0.15),
                 random.uniform(-0.15, 0.15));
    REQUIRE(nearest(p).distance == test::distanceToMesh(torus, p));
  }
}

TEST_CASE("the Visible Human liver at 5 mm keeps its volume, its place and its normals") {
  const auto liver = test::visibleHumanLiver();
  if (!liver) return;
  Discretization cells = discretize(*liver, latticeForSpacing(bounds(*liver), 0.005));
  REQUIRE(cells.particleCount() == 13114);
  const Likeness fractional = likeness(cells, *liver);
  CHECK(std::abs(fractional.volumeError) < 0.01);
  CHECK(fractional.deviation.distance < 0.45e-3);
  CHECK(fractional.deviation.faceAngle < 5.5);
  CHECK(fractional.deviation.shadingAngle < 6);

  // Fitted values lie nearer to it still.
  Discretization fitted = cells;
  fitSurface(*liver, fitted);
  const Likeness fit = likeness(fitted, *liver);
  CHECK(std::abs(fit.volumeError) < 0.3 * std::abs(fractional.volumeError));
  CHECK(fit.deviation.distance < 0.75 * fractional.deviation.distance);
  CHECK(fit.deviation.shadingAngle < 0.85 * fractional.deviation.shadingAngle);

  // Values of 0 or 100, as in the thesis, show stairs.
  for (std::size_t i = 0; i < cells.value.size(); ++i)
    cells.value.set(i, cells.inside[i] ? 100 : 0);
  const Likeness stairs = likeness(cells, *liver);
  CHECK(stairs.deviation.distance > 2 * fractional.deviation.distance);
  CHECK(stairs.deviation.faceAngle > 2 * fractional.deviation.faceAngle);
  report("fractional", fractional);
  report("fitted", fit);
  report("0 or 100", stairs);
}
