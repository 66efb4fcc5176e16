// Is an argument that cannot be right refused in one sentence, and nothing done?
#include <doctest/doctest.h>

#include <limits>

#include "geometry/primitives.h"
#include "organ/builtin/blended_shape.h"
#include "organ/builtin/builtin_gallbladder.h"
#include "organ/builtin/builtin_liver.h"
#include "organ/cell_labels.h"
#include "organ/discretize.h"
#include "organ/fit_surface.h"
#include "organ/organ.h"
#include "support/block_organ.h"
#include "support/sentence.h"

using namespace resect;
using test::refuses;

namespace {
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kEndless = std::numeric_limits<double>::infinity();
const Aabb kBox{Vec3::Zero(), Vec3::Constant(0.1)};
}  // namespace

TEST_CASE("lattices of cells without size, or over nothing, are refused") {
  for (const double wrong : {0.0, -0.005, kNaN, kEndless}) {
    CHECK(refuses([&] { latticeForSpacing(kBox, wrong); }, "above zero"));
    Lattice lattice = latticeForSpacing(kBox, 0.02);
    lattice.spacing.x() = wrong;
    CHECK(refuses([&] { discretize(boxMesh(kBox), lattice); }, "lengths above 0"));
  }
  CHECK(refuses([] { latticeForSpacing({}, 0.005); }, "empty mesh"));
  CHECK(refuses([] { latticeForSpacing(kBox, 1e-9); }, "larger spacing"));
  CHECK(refuses(
      [] {
        latticeForSpacing({Vec3::Zero(), Vec3::Constant(kEndless)}, 0.005);
      },
      "larger spacing"));
  CHECK(refuses([] { latticeForDims(kBox, {0, 1, 1}); }, "at least one cell"));
  CHECK(refuses([] { latticeForDims({}, {1, 1, 1}); }, "closed body"));
  CHECK(refuses([] { cubicLatticeForDims(kBox, -1); }, "at least one cell"));
  Lattice huge = latticeForSpacing(kBox, 0.02);
  huge.dims = Vec3i::Constant(1'000'000);
  CHECK(refuses([&] { discretize(boxMesh(kBox), huge); }, "larger spacing"));
}

TEST_CASE("a mesh that is none fills no cells") {
  const Lattice lattice = latticeForSpacing(kBox, 0.02);
  TriangleMesh mesh = boxMesh(kBox);
  Discretization cells = discretize(mesh, lattice);
  mesh.triangles[0][0] = 99;
  CHECK(refuses([&] { discretize(mesh, lattice); }, "uses a point"));
  CHECK(refuses([&] { fitSurface(mesh, cells); }, "uses a point"));
  mesh = boxMesh(kBox);
  mesh.points[0].z() = kNaN;
  CHECK(refuses([&] { discretize(mesh, lattice); }, "not finite"));
  CHECK(discretize({}, lattice).particleCount() == 0);
  cells.inside.pop_back();
  CHECK(refuses([&] { fitSurface(boxMesh(kBox), cells); }, "flags"));
}

TEST_CASE(
    "an organ of cells that do not fit, of nothing, or with settings out of range is refused") {
  for (const int refine : {-1, 0, 5})
    CHECK(refuses([&] { makeOrgan(test::ball(8), {.refine = refine}); }, "refine"));
  for (const float iso : {0.f, 99.f, std::numeric_limits<float>::quiet_NaN()})
    CHECK(refuses([&] { makeOrgan(test::ball(8), {.iso = iso}); }, "iso level"));
  CHECK(refuses([] { makeOrgan({}, {}); }, "no particle"));
  Discretization cells = test::ball(8);
  cells.inside.resize(20);
  CHECK(refuses([&] { makeOrgan(cells, {}); }, "20 flags"));
  cells = test::ball(8);
  cells.lattice.spacing.x() = kNaN;
  CHECK(refuses([&] { makeOrgan(cells, {}); }, "lengths above 0"));
  Organ organ = makeOrgan(test::ball(8), {});
  CHECK(refuses([&] { setIso(organ, 0); }, "iso level"));
  CHECK(organ.iso == 50);
  for (const int label : {-1, 256})
    CHECK(refuses([&] { markCells(organ.rest, label, {}); }, "give 0 to 255"));
  CHECK(organ.rest.label.empty());
}

TEST_CASE("built-in organs in triangles out of range, and blends that are none, are refused") {
  for (const double wrong : {0.0, 1.0, -0.002, kNaN}) {
    CHECK(refuses([&] { builtinLiver(wrong); }, "longest edge of the liver"));
    CHECK(refuses([&] { builtinGallbladder(wrong); }, "longest edge of the gallbladder"));
  }
  std::vector<BlendedEllipsoid> ellipsoids(65);
  CHECK(refuses([&] { BlendedShape{ellipsoids}; }, "65 ellipsoids"));
  ellipsoids.resize(2);
  ellipsoids[1].radii.y() = 0;
  CHECK(refuses([&] { BlendedShape{ellipsoids}; }, "ellipsoid 1 has radii"));
  ellipsoids[1] = {};
  ellipsoids[1].fillet = kNaN;
  CHECK(refuses([&] { BlendedShape{ellipsoids}; }, "fillet"));
}
