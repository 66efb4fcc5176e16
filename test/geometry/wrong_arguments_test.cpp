// Is an argument that cannot be right refused in one sentence, and nothing done?
#include <doctest/doctest.h>

#include <limits>

#include "geometry/farthest_point.h"
#include "geometry/measures.h"
#include "geometry/normals.h"
#include "geometry/primitives.h"
#include "geometry/repair/repair.h"
#include "geometry/resting_pose.h"
#include "geometry/topology.h"
#include "support/sentence.h"

using namespace resect;
using test::refuses;

TEST_CASE(
    "a triangle at a point that there is not is refused, and a mesh of nothing is none's fault") {
  for (const std::int32_t wrong : {-1, 8, std::numeric_limits<std::int32_t>::min()}) {
    TriangleMesh mesh = boxMesh({Vec3::Zero(), Vec3::Ones()});
    mesh.triangles[5][1] = wrong;
    const char* what = "uses a point beyond its";
    CHECK(refuses([&] { requireTriangles(mesh); }, what));
    CHECK(refuses([&] { requireSound(mesh); }, what));
    CHECK(refuses([&] { area(mesh); }, what));
    CHECK(refuses([&] { volume(mesh); }, what));
    CHECK(refuses([&] { centroid(mesh); }, what));
    CHECK(refuses([&] { pointNormals(mesh); }, what));
    CHECK(refuses([&] { topology(mesh); }, what));
    CHECK(refuses([&] { splitComponents(mesh); }, what));
    CHECK(refuses([&] { restingRotation(mesh); }, what));
    RepairReport report;
    const auto before = mesh.triangles;
    CHECK(refuses([&] { orientConsistently(mesh, report); }, what));
    CHECK(refuses([&] { closeHoles(mesh, report); }, what));
    CHECK(mesh.triangles == before);
  }
  const TriangleMesh nothing;
  requireSound(nothing);
  CHECK(volume(nothing) == 0);
  CHECK(topology(nothing).closed());
}

TEST_CASE("a point that is not finite is refused where numbers are needed") {
  for (const double wrong :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    TriangleMesh mesh = boxMesh({Vec3::Zero(), Vec3::Ones()});
    mesh.points[3].y() = wrong;
    CHECK(refuses([&] { requireSound(mesh); }, "not finite"));
    CHECK(refuses([&] { FarthestPoint{mesh.points}; }, "not finite"));
  }
  CHECK(refuses([] { FarthestPoint{{}}; }, "give at least one"));
}
