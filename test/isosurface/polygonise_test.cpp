#include "isosurface/polygonise.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "base/parallel.h"
#include "geometry/measures.h"
#include "geometry/topology.h"

using namespace resect;

namespace {

const Aabb kBox{Vec3::Constant(-0.05), Vec3::Constant(0.05)};

double ballField(const Vec3& p) { return (p - Vec3(0.001, 0.002, -0.003)).norm() - 0.03; }

// Ring of radius 30 mm around the y axis, 10 mm thick.
double ringField(const Vec3& p) {
  return std::hypot(std::hypot(p.x(), p.z()) - 0.03, p.y()) - 0.01;
}

void checkSkin(const TriangleMesh& mesh) {
  const Topology found = topology(mesh);
  CHECK(found.closed());
  CHECK(found.oriented());
  CHECK(found.manifold());
}

int euler(const TriangleMesh& mesh) {
  return int(mesh.points.size()) - int(mesh.triangles.size()) / 2;
}

}  // namespace

TEST_CASE("a ball becomes a sphere of the right size, with its points on the surface") {
  const TriangleMesh mesh = polygonise(ballField, kBox, {.edge = 0.002});
  checkSkin(mesh);
  CHECK(topology(mesh).components == 1);
  CHECK(euler(mesh) == 2);
  for (const Vec3& p : mesh.points) CHECK(std::abs(ballField(p)) < 1e-6);
  // An inscribed mesh of edges e misses about (e / r)^2 / 4 of the volume.
  const double exact = 4.0 / 3 * std::numbers::pi * std::pow(0.03, 3);
  CHECK(volume(mesh) < exact);
  CHECK(volume(mesh) > exact * (1 - 0.25 * std::pow(0.002 / 0.03, 2)));
}

TEST_CASE("a ring keeps its hole") {
  const TriangleMesh mesh = polygonise(ringField, kBox, {.edge = 0.003});
  checkSkin(mesh);
  CHECK(topology(mesh).components == 1);
  CHECK(euler(mesh) == 0);
}

TEST_CASE("any function gives a closed, oriented, manifold surface") {
  // Noise around zero: every case of a tetrahedron, many pieces, handles, and the border of the
  // box.
  const auto noise = [](const Vec3& p) {
    return std::sin(900 * p.x() + 3 * std::cos(700 * p.y())) + std::cos(1100 * p.z() + 500 * p.x());
  };
  for (int smoothing : {0, 3}) {
    const TriangleMesh mesh = polygonise(noise, {Vec3::Constant(-0.01), Vec3::Constant(0.01)},
                                         {.edge = 0.001, .smoothing = smoothing});
    CHECK(mesh.triangles.size() > 1000);
    checkSkin(mesh);
  }
}

TEST_CASE("a body that reaches out of the box is closed at its border") {
  const auto slab = [](const Vec3& p) { return std::abs(p.y()) - 0.01; };
  const TriangleMesh mesh = polygonise(slab, kBox, {.edge = 0.004, .smoothing = 0});
  checkSkin(mesh);
  CHECK(volume(mesh) == doctest::Approx(0.1 * 0.1 * 0.02).epsilon(0.02));
}

TEST_CASE("skipping boxes by the Lipschitz bound loses nothing") {
  const TriangleMesh all = polygonise(ringField, kBox, {.edge = 0.002});
  const TriangleMesh skipped = polygonise(ringField, kBox, {.edge = 0.002, .lipschitz = 1});
  CHECK(all.points.size() == skipped.points.size());
  CHECK(all.triangles.size() == skipped.triangles.size());
  CHECK(volume(all) == doctest::Approx(volume(skipped)).epsilon(1e-9));
}

TEST_CASE("evening out removes slivers") {
  const auto shortest = [](const TriangleMesh& mesh) {
    double least = 1;
    for (const Triangle& t : mesh.triangles)
      for (int e = 0; e < 3; ++e)
        least = std::min(least, (mesh.points[t[e]] - mesh.points[t[(e + 1) % 3]]).norm());
    return least;
  };
  CHECK(shortest(polygonise(ballField, kBox, {.edge = 0.003, .smoothing = 0})) < 0.0003);
  CHECK(shortest(polygonise(ballField, kBox, {.edge = 0.003})) > 0.0006);
}

TEST_CASE("the surface has the same bits at one, two and three threads") {
  const TriangleMesh reference = polygonise(ringField, kBox, {.edge = 0.003});
  for (int threads : {1, 2, 3}) {
    const ThreadLimit limit(threads);
    const TriangleMesh mesh = polygonise(ringField, kBox, {.edge = 0.003});
    CHECK(mesh.points == reference.points);
    CHECK(mesh.triangles == reference.triangles);
  }
}

TEST_CASE("a function of one sign, or an empty box, has no surface") {
  CHECK(polygonise([](const Vec3&) { return 1.0; }, kBox).triangles.empty());
  CHECK(polygonise(ballField, Aabb{}).triangles.empty());
}

TEST_CASE("a margin thinner than the edges is not frayed") {
  // Two balls' common part: a lens with a sharp rim of radius 24 mm in the plane x = 0.
  const auto lens = [](const Vec3& p) {
    return std::max((p - Vec3(0.018, 0, 0)).norm(), (p + Vec3(0.018, 0, 0)).norm()) - 0.03;
  };
  const auto reach = [&](int smoothing) {  // least of the mesh's extent over directions of the rim
    const TriangleMesh mesh = polygonise(lens, kBox, {.edge = 0.003, .smoothing = smoothing});
    checkSkin(mesh);
    double least = 1;
    for (int i = 0; i < 90; ++i) {
      const double angle = i * std::numbers::pi / 45;
      const Vec3 direction(0, std::cos(angle), std::sin(angle));
      double most = 0;
      for (const Vec3& p : mesh.points)
        if ((p.normalized() - direction).norm() < 0.06) most = std::max(most, p.norm());
      least = std::min(least, most);
    }
    return least;
  };
  CHECK(reach(3) > 0.0237);
  CHECK(reach(3) > reach(0));
}
