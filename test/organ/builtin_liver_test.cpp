#include "organ/builtin/builtin_liver.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "geometry/measures.h"
#include "geometry/topology.h"
#include "support/references/mesh_reference.h"
#include "support/shared_data.h"

using namespace resect;

namespace {

// Heights at which the upright line through x, z meets the mesh, sorted; plain and slow.
std::vector<double> crossings(const TriangleMesh& mesh, double x, double z) {
  std::vector<double> heights;
  for (const Triangle& t : mesh.triangles) {
    double area[3], sum = 0, y = 0;
    for (int e = 0; e < 3; ++e) {
      const Vec3 &a = mesh.points[t[(e + 1) % 3]], &b = mesh.points[t[(e + 2) % 3]];
      area[e] = (a.x() - x) * (b.z() - z) - (a.z() - z) * (b.x() - x);
      sum += area[e];
      y += area[e] * mesh.points[t[e]].y();
    }
    const bool up = area[0] > 0 && area[1] > 0 && area[2] > 0;
    const bool down = area[0] < 0 && area[1] < 0 && area[2] < 0;
    if (up || down) heights.push_back(y / sum);
  }
  std::sort(heights.begin(), heights.end());
  return heights;
}

bool inLiver(double x, double y, double z) {  // millimetres
  return builtinLiverDistance(Vec3(x, y, z) * 1e-3) < 0;
}

}  // namespace

TEST_CASE("the built-in liver is one closed piece without handles, of a liver's size") {
  for (double edge : {0.0025, 0.005}) {
    const TriangleMesh mesh = builtinLiver(edge);
    const Topology found = topology(mesh);
    CHECK(found.closed());
    CHECK(found.oriented());
    CHECK(found.manifold());
    CHECK(found.components == 1);
    CHECK(int(mesh.points.size()) - int(mesh.triangles.size()) / 2 == 2);  // Euler: genus 0
    CHECK(volume(mesh) > 1.2e-3);
    CHECK(volume(mesh) < 1.8e-3);
    CHECK(centroid(mesh).norm() < 0.003);
    // Nothing is cut off at the border of the box it is meshed in.
    for (const Vec3& p : mesh.points) CHECK(std::abs(builtinLiverDistance(p)) < 2e-4);
  }
}

TEST_CASE("the built-in liver has the lobes and faces of a liver") {
  CHECK(inLiver(-20, 0, -20));   // right lobe
  CHECK(inLiver(90, 30, 50));    // left lobe, thin
  CHECK(!inLiver(90, 0, 30));    // under it: the stomach
  CHECK(!inLiver(90, 65, 30));   // above it: the heart
  CHECK(inLiver(0, 60, 0));      // dome
  CHECK(!inLiver(0, -40, 40));   // under the hollow visceral face
  CHECK(inLiver(-45, -70, 20));  // the inferior margin hangs down on the right
  CHECK(inLiver(54, 5, -12));    // caudate lobe
}

TEST_CASE("groove of the vena cava, umbilical fissure and gallbladder fossa are there") {
  // Outside in the groove, inside on both of its banks.
  CHECK(!inLiver(45, 0, -26));
  CHECK(inLiver(30, 0, -26));
  CHECK(inLiver(53, 0, -16));
  // Fissure: between the quadrate lobe and the left lateral part.
  CHECK(!inLiver(47.5, -8, 45));
  CHECK(inLiver(38, -6, 45));
  CHECK(inLiver(58, -8, 45));
  // Fossa: to the right of the quadrate lobe, open downwards.
  CHECK(!inLiver(-4, -12, 45));
  CHECK(!inLiver(-4, -40, 45));
  CHECK(inLiver(14, -6, 45));
  CHECK(inLiver(-26, -8, 45));
}

TEST_CASE("the margin is sharp below and at the left end, the dome is round") {
  // The share of a small ball around a surface point that is liver: half on a flat place.
  const auto share = [](const Vec3& at) {
    int inside = 0, all = 0;
    for (int i = -8; i <= 8; ++i)
      for (int j = -8; j <= 8; ++j)
        for (int k = -8; k <= 8; ++k) {
          if (i * i + j * j + k * k > 64) continue;
          ++all;
          inside += builtinLiverDistance(at + 0.001 * Vec3(i, j, k)) < 0;
        }
    return double(inside) / all;
  };
  const TriangleMesh mesh = builtinLiver(0.004);
  const auto extreme = [&](const Vec3& direction) {
    return *std::max_element(
        mesh.points.begin(), mesh.points.end(),
        [&](const Vec3& a, const Vec3& b) { return a.dot(direction) < b.dot(direction); });
  };
  CHECK(share(extreme({0, -1, 0})) < 1.0 / 3);
  CHECK(share(extreme({1, 0, 0})) < 0.25);
  CHECK(share(extreme({0, 1, 0})) > 0.4);
}

TEST_CASE("the built-in liver overlaps the Visible Human's by a Dice of at least 0.93") {
  const auto path = test::sharedData("visible-human-male/VH_M_liver_closed.obj");
  if (!path) return;
  TriangleMesh real = test::readPlainObj(path->string());
  REQUIRE(real.triangles.size() == 16898);
  // Rigid motion and scale: centre on centre and volume on volume is enough.
  const TriangleMesh ours = builtinLiver();
  const Vec3 centre = centroid(real), ourCentre = centroid(ours);
  const double scale = std::cbrt(volume(ours) / volume(real));
  for (Vec3& p : real.points) p = scale * (p - centre) + ourCentre;
  const Aabb box = bounds(real).padded(0.01);
  constexpr double kStep = 0.004;
  long both = 0, mine = 0, theirs = 0;
  for (double x = box.min.x(); x < box.max.x(); x += kStep)
    for (double z = box.min.z(); z < box.max.z(); z += kStep) {
      const std::vector<double> heights = crossings(real, x, z);
      for (double y = box.min.y(); y < box.max.y(); y += kStep) {
        const bool a = builtinLiverDistance({x, y, z}) < 0;
        const auto above = heights.end() - std::upper_bound(heights.begin(), heights.end(), y);
        const bool b = above % 2 == 1;
        mine += a, theirs += b, both += a && b;
      }
    }
  const double dice = 2.0 * double(both) / double(mine + theirs);
  MESSAGE("Dice " << dice);
  CHECK(dice >= 0.93);
}
