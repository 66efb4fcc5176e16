#include "surface/surface_tracker.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <set>

#include "base/parallel.h"
#include "base/random.h"
#include "geometry/measures.h"
#include "geometry/topology.h"
#include "isosurface/marching_cubes_table.h"
#include "support/block_organ.h"
#include "support/surface_look.h"

using namespace resect;

namespace {

bool isSkinOfBody(const TriangleMesh& mesh) {
  const Topology t = topology(mesh);
  return t.closed() && t.oriented() && t.manifold();
}

bool sameSurface(const SurfaceTracker::Compact& a, const SurfaceTracker::Compact& b) {
  return a.mesh.points == b.mesh.points && a.mesh.triangles == b.mesh.triangles &&
         a.normals == b.normals && a.cut == b.cut;
}

}  // namespace

TEST_CASE("no diagonal of the marching-cubes table lies in a face of the cell") {
  const auto& table = marchingCubesTable();
  for (int c = 0; c < 256; ++c)
    for (int t = 0; t < table[c].count; ++t)
      for (int i = 0; i < 3; ++i) {
        const int e = table[c].edges[t][i], f = table[c].edges[t][(i + 1) % 3];
        // An edge of a triangle inside the cell is used twice, in opposite directions; one in a
        // face once.
        int uses = 0;
        for (int u = 0; u < table[c].count; ++u)
          for (int j = 0; j < 3; ++j) {
            const int g = table[c].edges[u][j], h = table[c].edges[u][(j + 1) % 3];
            uses += (g == e && h == f) || (g == f && h == e);
          }
        const auto coordinate = [](int edge, int axis) {
          const CellEdge k = kCellEdges[edge];
          return axis == k.axis ? 1 : 2 * (k.from >> axis & 1);
        };
        bool inFace = false;
        for (int a = 0; a < 3; ++a)
          inFace |= coordinate(e, a) == coordinate(f, a) && coordinate(e, a) != 1;
        CHECK(uses == (inFace ? 1 : 2));
      }
}

TEST_CASE("a box finds every triangle that it meets, and few others") {
  const ColourField field(test::fullBlock({20, 16, 12}), 2);
  const SurfaceTracker surface(field, 50);
  const Aabb all = bounds(surface.mesh().points);
  const double brick = kBrickNodes * field.lattice().spacing.x() / 2;
  Random random(8);
  for (int i = 0; i < 50; ++i) {
    Aabb box;
    for (int k = 0; k < 2; ++k)
      box.grow(Vec3(all.min + Vec3(random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1))
                                  .cwiseProduct(all.size())));
    if (i % 2 == 0) {  // an endless column
      box.min.y() = -std::numeric_limits<double>::infinity();
      box.max.y() = -box.min.y();
    }
    const auto boundsOf = [&](const Triangle& t) {
      Aabb of;
      for (const std::int32_t v : t) of.grow(Vec3(surface.points()[std::size_t(v)].cast<double>()));
      return of;
    };
    std::multiset<Triangle> found;
    surface.visitTriangles(field, box, [&](const Triangle& t) {
      found.insert(t);
      CHECK_FALSE(intersection(boundsOf(t), box.padded(1.001 * brick)).empty());
    });
    for (const Triangle& t : surface.triangles())
      if (t[0] != t[1] && !intersection(boundsOf(t), box).empty()) CHECK(found.count(t) == 1);
  }
}

TEST_CASE(
    "the table draws nothing in empty and full cells and one triangle round a single corner") {
  const auto& table = marchingCubesTable();
  CHECK(table[0].count == 0);
  CHECK(table[255].count == 0);
  for (int c = 0; c < 8; ++c) CHECK(table[1 << c].count == 1);
}

TEST_CASE("a ball's surface is closed, looks outwards and has its volume") {
  for (int refine : {1, 2, 3, 4}) {
    const Discretization d = test::ball(24);
    const ColourField field(d, refine);
    const auto surface = test::withLook(field, 50);
    CHECK(isSkinOfBody(surface.mesh));
    CHECK(topology(surface.mesh).components == 1);
    CHECK(std::abs(volume(surface.mesh) / d.volume() - 1) < 0.02);
    const Vec3 middle = d.lattice.box().centre();
    for (std::size_t i = 0; i < surface.mesh.points.size(); ++i) {
      const Vec3 radial = (surface.mesh.points[i] - middle).normalized();
      REQUIRE(surface.normals[i].cast<double>().dot(radial) > 0.97);
      REQUIRE(surface.cut[i] == 0);
    }
  }
}

TEST_CASE("any field gives a closed oriented manifold surface at any iso level") {
  for (int seed = 0; seed < 12; ++seed) {
    const ColourField field(test::noise({6 + seed % 5, 7, 9 - seed % 4}, seed), 1 + seed % 4);
    for (float iso : {kMinIso, 20.f, 50.f, 80.f, kMaxIso})
      CHECK(isSkinOfBody(SurfaceTracker(field, iso).mesh()));
  }
}

TEST_CASE(
    "after 100 000 edits in any order the surface equals a rebuild bit for bit and stays closed") {
  for (int refine : {1, 2, 3}) {
    Discretization d = test::ball(18);
    ColourField field(d, refine);
    SurfaceTracker tracker(field, 50);
    Random random(77 + refine);
    for (int edit = 0; edit < 33'400; ++edit) {
      const int cell = random.below(int(d.value.size()));
      const bool back = random.below(5) < edit / 1000 % 5;  // from whole to dust and back
      field.setCellValue(cell, back ? d.value[cell] : 0.f);
      tracker.update(field, field.update());
      if (edit % 50 != 49) continue;
      Discretization now = d;
      for (std::int64_t i = 0; i < d.lattice.cellCount(); ++i) now.value.set(i, field.cellValue(i));
      const auto compact = test::withLook(tracker, field);
      const auto rebuilt = test::withLook(field, 50);
      REQUIRE(sameSurface(compact, rebuilt));
      // From the cells alone the mesh is the same too; only what was cut is not known to them.
      const ColourField fresh(now, refine);
      const auto anew = test::withLook(fresh, 50);
      REQUIRE(compact.mesh.points == anew.mesh.points);
      REQUIRE(compact.mesh.triangles == anew.mesh.triangles);
      REQUIRE(isSkinOfBody(compact.mesh));
      REQUIRE(tracker.triangleCount() == std::int64_t(compact.mesh.triangles.size()));
    }
  }
}

TEST_CASE("field and surface made together are those made one after the other") {
  // Noise, which holds far more surface than there is room for from the start, in many stretches of
  // the walk; and bodies that are full and empty over whole rows of bricks.
  for (const int refine : {1, 2, 3, 4})
    for (const Discretization& d : {test::noise({48, 40, 36}, 9), test::ball(40),
                                    test::fullBlock({70, 3, 20}), test::fullBlock({1, 1, 1}),
                                    test::fill({9, 9, 9}, 0.01, [](const Vec3i&) { return 0; })}) {
      TriangleMesh first;  // the walk's stretches end elsewhere with each number of threads
      for (const int threads : {1, 2, 3}) {
        const ThreadLimit limit(threads);
        const auto [field, surface] = buildFieldAndSurface(d, refine, 50);
        const ColourField apart(d, refine);
        for (std::int64_t b = 0; b < apart.brickCount(); ++b) {
          REQUIRE(field.slot(b) == apart.slot(b));
          REQUIRE(std::equal(field.nodes(b), field.nodes(b) + kBrickSize, apart.nodes(b)));
        }
        const TriangleMesh mesh = surface.mesh(), after = SurfaceTracker(apart, 50).mesh();
        if (threads == 1) first = mesh;
        REQUIRE(mesh.points == first.points);
        REQUIRE(mesh.triangles == first.triangles);
        REQUIRE(mesh.points == after.points);
        REQUIRE(mesh.triangles == after.triangles);
      }
      CHECK(isSkinOfBody(first));
    }
}

TEST_CASE("another iso level after edits gives the surface of the cells that are left") {
  Discretization d = test::noise({24, 30, 28}, 3);
  ColourField field(d, 2);
  SurfaceTracker tracker(field, 50);
  Random random(8);
  for (int k = 0; k < 300; ++k) {
    const int cell = random.below(int(d.value.size()));
    d.value.set(std::size_t(cell), 0);
    field.setCellValue(cell, 0);
  }
  tracker.update(field, field.update());
  tracker.setIso(field, 40);
  const SurfaceTracker fresh = buildFieldAndSurface(d, 2, 40).surface;
  CHECK(tracker.mesh().points == fresh.mesh().points);
  CHECK(tracker.mesh().triangles == fresh.mesh().triangles);
}

TEST_CASE("a look that is asked for late is the look that was kept up, and costs no memory") {
  const Discretization d = test::noise({20, 18, 16}, 11);
  ColourField field(d, 2);
  SurfaceTracker kept(field, 50), late(field, 50);
  kept.updateLook(field);
  late.updateLook(field);
  const std::size_t before = late.bytes();
  Random random(5);
  for (int edit = 0; edit < 4000; ++edit) {
    const int cell = random.below(int(d.value.size()));
    field.setCellValue(cell, random.below(2) == 0 ? 0.f : d.value[cell]);
    const auto touched = field.update();
    kept.update(field, touched);
    kept.updateLook(field);
    late.update(field, touched);
    // A few edits, and more than there are bricks.
    if (edit == 3 || edit == 3999)
      REQUIRE(sameSurface(test::withLook(late, field), kept.compact()));
  }
  CHECK(late.bytes() < 2 * before);
}

TEST_CASE("a carved organ shows its cut face as cut and its skin as skin") {
  const Discretization d = test::ball(24);
  ColourField field(d, 2);
  SurfaceTracker tracker(field, 50);
  for (std::int64_t i = 0; i < d.lattice.cellCount(); ++i)
    if (d.lattice.cell(i).x() > 14) field.setCellValue(i, 0);
  tracker.update(field, field.update());
  const auto surface = test::withLook(tracker, field);
  const double face = d.lattice.centre({14, 0, 0}).x();
  const Vec3 middle = d.lattice.box().centre();
  int skin = 0, cut = 0;
  for (std::size_t i = 0; i < surface.mesh.points.size(); ++i) {
    const Vec3 p = surface.mesh.points[i];
    if (p.x() < face - 0.01) {
      CHECK(surface.cut[i] == 0);
      ++skin;
    }
    const double aside = (p - middle).tail<2>().norm();
    if (p.x() > face && aside < 0.03) {
      CHECK(surface.cut[i] == 1);
      ++cut;
    }
  }
  CHECK(skin > 100);
  CHECK(cut > 100);
}

TEST_CASE(
    "changing the iso level there and back restores the surface, and a lower level encloses more") {
  const ColourField field(test::ball(16), 2);
  SurfaceTracker tracker(field, 50);
  const auto before = test::withLook(tracker, field);
  tracker.setIso(field, 30);
  CHECK(volume(tracker.mesh()) > volume(before.mesh));
  tracker.setIso(field, 50);
  CHECK(sameSurface(test::withLook(tracker, field), before));
}

TEST_CASE("the surface has the same bits at 1, 2 and 3 threads, edits included") {
  std::vector<SurfaceTracker::Compact> results;
  for (int threads : {1, 2, 3}) {
    const ThreadLimit limit(threads);
    const Discretization d = test::ball(20);
    ColourField field(d, 2);
    SurfaceTracker tracker(field, 50);
    Random random(9);
    for (int edit = 0; edit < 20; ++edit) {
      for (int i = 0; i < 30; ++i) field.setCellValue(random.below(int(d.value.size())), 0);
      tracker.update(field, field.update());
    }
    results.push_back(test::withLook(tracker, field));
  }
  CHECK(sameSurface(results[0], results[1]));
  CHECK(sameSurface(results[0], results[2]));
}

TEST_CASE("applying only the reported changes to a viewer's copy reproduces the arrays") {
  const Discretization d = test::ball(18);
  ColourField field(d, 2);
  SurfaceTracker tracker(field, 50);
  std::vector<Vec3f> points(tracker.points().begin(), tracker.points().end());
  std::vector<Triangle> triangles(tracker.triangles().begin(), tracker.triangles().end());
  Random random(4);
  for (int edit = 0; edit < 60; ++edit) {
    for (int i = 0; i < 8; ++i) field.setCellValue(random.below(int(d.value.size())), 0);
    tracker.update(field, field.update());
    points.resize(tracker.points().size(), Vec3f::Zero());
    triangles.resize(tracker.triangles().size(), Triangle{0, 0, 0});
    for (const IndexRange& r : tracker.changes().vertices)
      std::copy_n(tracker.points().begin() + r.first, r.count, points.begin() + r.first);
    for (const IndexRange& r : tracker.changes().triangles)
      std::copy_n(tracker.triangles().begin() + r.first, r.count, triangles.begin() + r.first);
    REQUIRE(std::ranges::equal(points, tracker.points()));
    REQUIRE(std::ranges::equal(triangles, tracker.triangles()));
  }
}

TEST_CASE("the cost of a cut does not depend on the size of the organ") {
  std::vector<std::int64_t> bricks;
  for (int n : {20, 40, 60}) {
    const Discretization d = test::fullBlock({n, n, n});
    ColourField field(d, 2);
    SurfaceTracker tracker(field, 50);
    for (int x = 4; x < 8; ++x) field.setCellValue(d.lattice.index({x, 8, 0}), 0);
    tracker.update(field, field.update());
    bricks.push_back(tracker.changes().bricks);
  }
  CHECK(bricks[0] == bricks[1]);
  CHECK(bricks[0] == bricks[2]);
}

TEST_CASE("an empty organ has an empty surface, one cell alone none at iso 50 but one at iso 30") {
  const ColourField none(test::fill({4, 4, 4}, 0.01, [](const Vec3i&) { return 0.0; }), 2);
  CHECK(SurfaceTracker(none, 50).mesh().triangles.empty());
  const ColourField one(test::fullBlock({1, 1, 1}), 2);
  CHECK(SurfaceTracker(one, 50).mesh().triangles.empty());
  CHECK(isSkinOfBody(SurfaceTracker(one, 30).mesh()));
  CHECK_FALSE(SurfaceTracker(one, 30).mesh().triangles.empty());
}
