#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/parallel.h"
#include "geometry/measures.h"
#include "geometry/topology.h"
#include "isosurface/brick_look.h"
#include "support/blades.h"
#include "support/random_edits.h"
#include "support/references/wound_reference.h"
#include "support/surface_look.h"
#include "surface/surface_tracker.h"
#include "wound/blade_raster.h"

using namespace resect;

namespace {

// An organ with its surface, cut and carved step by step.
struct Patient {
  Discretization cells;
  ColourField field;
  SeveredEdges severed;
  std::vector<std::uint8_t> particles;
  SurfaceTracker surface;

  Patient(const Discretization& d, int refine)
      : cells(d),
        field(d, refine),
        severed(field.brickDims(), field.refine()),
        particles(d.inside),
        surface(field, 50) {}
  Wound wound() const { return {severed, particles}; }
  void follow() {
    const auto touched = field.update();
    surface.update(field, touched, wound(), severed.update());
  }
  void cut(const SweptBlade& blade) { severAtRest(severed, field, 50, blade); }
  void set(std::int64_t cell, float value) {
    field.setCellValue(cell, value);
    particles[std::size_t(cell)] = value > 0 && cells.inside[std::size_t(cell)];
  }
  Vec3 middle() const { return field.lattice().box().centre(); }
  double spacing() const { return field.lattice().spacing.x(); }
  SweptBlade someBlade(Random& random) const {
    return test::randomBlade(middle(), 0.5 * field.lattice().box().size().x(), spacing(), random);
  }
};

std::vector<VertexBinding> bindings(const SurfaceTracker& surface) {
  std::vector<VertexBinding> all;
  surface.visitBindings([&](std::int32_t, std::span<const VertexBinding> bound) {
    all.insert(all.end(), bound.begin(), bound.end());
  });
  return all;
}

bool sameBinding(const VertexBinding& a, const VertexBinding& b) {
  return a.count == b.count && a.cell == b.cell && a.weight == b.weight;
}

void requireSame(const ColourField& field, SurfaceTracker& a, SurfaceTracker&& b) {
  const auto one = test::withLook(a, field), other = test::withLook(b, field);
  REQUIRE(one.mesh.points == other.mesh.points);
  REQUIRE(one.mesh.triangles == other.mesh.triangles);
  REQUIRE(one.normals == other.normals);
  REQUIRE(one.cut == other.cut);
  REQUIRE(std::ranges::equal(bindings(a), bindings(b), sameBinding));
}

}  // namespace

TEST_CASE("the wound in bricks is the wound that the plain mesher draws") {
  for (int run = 0; run < 12; ++run) {
    INFO("run ", run);
    Random random(std::uint64_t(run) + 70);
    Patient p(test::blob(14), 1 + run % 3);
    for (int blade = 0; blade < 2; ++blade) p.cut(p.someBlade(random));
    p.follow();
    test::GridOrgan organ(p.field.nodeDims());
    organ.fill([&](const Vec3i& n) { return p.field.node(n); });
    organ.take(p.severed);
    const auto plain = test::woundMesh(organ.view(&p.severed));
    const TriangleMesh mesh = p.surface.mesh();
    REQUIRE(test::wrongWith(mesh) == "");
    REQUIRE(mesh.triangles.size() == plain.mesh.triangles.size());
    REQUIRE(mesh.points.size() == plain.mesh.points.size());
    // The same points, in another order.
    const auto key = [&](const Vec3& q) {
      return std::array<float, 3>{float(q.x()), float(q.y()), float(q.z())};
    };
    std::vector<std::array<float, 3>> ours, theirs;
    for (const Vec3& q : mesh.points) ours.push_back(key(q));
    for (const Vec3& q : plain.mesh.points) theirs.push_back(key(p.field.nodePosition(q)));
    std::sort(ours.begin(), ours.end());
    std::sort(theirs.begin(), theirs.end());
    double worst = 0;
    for (std::size_t i = 0; i < ours.size(); ++i)
      worst = std::max(worst, double(std::abs(ours[i][0] - theirs[i][0])));
    CHECK(worst < 1e-3 * p.spacing());
    const double cell = std::pow(p.spacing() / p.field.refine(), 3);
    CHECK(std::abs(volume(mesh) / (cell * volume(plain.mesh)) - 1) < 1e-6);
  }
}

TEST_CASE("after any mixture of incisions and removals the surface equals a rebuild bit for bit") {
  for (int refine : {1, 2, 3}) {
    const Discretization d = test::blob(14);
    Patient p(d, refine);
    Random random(std::uint64_t(5 + refine));
    for (int step = 0; step < 60; ++step) {
      INFO("refine ", refine, " step ", step);
      if (random.below(3) == 0) {
        for (const auto& [cell, value] : test::randomEdit(d, random)) p.set(cell, value);
      } else {
        p.cut(test::randomBlade(p.middle(), 0.2 * p.field.lattice().box().size().x(), p.spacing(),
                                random));
      }
      if (random.below(4) != 0) p.follow();
      if (step % 6 != 5) continue;
      p.follow();
      const Wound wound = p.wound();
      requireSame(p.field, p.surface, SurfaceTracker(p.field, 50, &wound));
      REQUIRE(test::wrongWith(p.surface.mesh()) == "");
      REQUIRE(p.surface.triangleCount() == std::int64_t(p.surface.mesh().triangles.size()));
    }
  }
}

TEST_CASE("a large organ with wounds is the same anew, in however many stretches it is meshed") {
  for (const int threads : {1, 3}) {
    const ThreadLimit limit(threads);  // some thousand bricks; a stretch has 1024 for each thread
    Patient p(test::noise({44, 40, 42}, 17), 2);
    Random random(4);
    for (int cut = 0; cut < 3; ++cut) {
      p.cut(test::randomBlade(p.middle(), 0.3 * p.field.lattice().box().size().x(), p.spacing(),
                              random));
      p.follow();
    }
    const Wound wound = p.wound();
    requireSame(p.field, p.surface, SurfaceTracker(p.field, 50, &wound));
  }
}

TEST_CASE("a wound changes no volume in the bricks, and removal after a cut works") {
  Patient p(test::blob(20), 2);
  const double whole = volume(p.surface.mesh());
  Random random(3);
  for (int i = 0; i < 5; ++i) p.cut(p.someBlade(random));
  p.follow();
  CHECK(std::abs(volume(p.surface.mesh()) / whole - 1) < 1e-7);  // points are floats
  for (std::int64_t i = 0; i < p.field.lattice().cellCount(); ++i)
    if (p.field.lattice().cell(i).x() > 9) p.set(i, 0);
  p.follow();
  CHECK(test::wrongWith(p.surface.mesh()) == "");
  CHECK(volume(p.surface.mesh()) < 0.6 * whole);
}

TEST_CASE("a wound has the same bits at 1, 2 and 3 threads") {
  std::vector<SurfaceTracker::Compact> results;
  for (int threads : {1, 2, 3}) {
    const ThreadLimit limit(threads);
    Patient p(test::blob(20), 2);
    Random random(11);
    for (int i = 0; i < 6; ++i) {
      p.cut(p.someBlade(random));
      p.follow();
    }
    results.push_back(test::withLook(p.surface, p.field));
  }
  for (std::size_t i : {1, 2}) {
    CHECK(results[i].mesh.points == results[0].mesh.points);
    CHECK(results[i].mesh.triangles == results[0].mesh.triangles);
    CHECK(results[i].normals == results[0].normals);
  }
}

TEST_CASE("the reported changes of a wound reproduce the arrays") {
  Patient p(test::blob(16), 2);
  std::vector<Vec3f> points(p.surface.points().begin(), p.surface.points().end());
  std::vector<Triangle> triangles(p.surface.triangles().begin(), p.surface.triangles().end());
  Random random(4);
  for (int step = 0; step < 20; ++step) {
    if (step % 3 == 2)
      for (const auto& [cell, value] : test::randomEdit(p.cells, random)) p.set(cell, value);
    else
      p.cut(p.someBlade(random));
    p.follow();
    points.resize(p.surface.points().size(), Vec3f::Zero());
    triangles.resize(p.surface.triangles().size(), Triangle{0, 0, 0});
    for (const IndexRange& r : p.surface.changes().vertices)
      std::copy_n(p.surface.points().begin() + r.first, r.count, points.begin() + r.first);
    for (const IndexRange& r : p.surface.changes().triangles)
      std::copy_n(p.surface.triangles().begin() + r.first, r.count, triangles.begin() + r.first);
    REQUIRE(std::ranges::equal(points, p.surface.points()));
    REQUIRE(std::ranges::equal(triangles, p.surface.triangles()));
  }
}

TEST_CASE("a wound is remeshed at the cost of its bricks, whatever the size of the organ") {
  std::vector<std::int64_t> bricks;
  for (int n : {20, 40}) {
    Patient p(test::fullBlock({n, n, n}), 2);
    const Vec3 corner = p.field.lattice().centre({8, 8, 0});
    p.cut(test::flatBlade(corner, Vec3(0.01, 0.002, 0), Vec3(0, 0, 0.01)));
    p.follow();
    bricks.push_back(p.surface.changes().bricks);
    CHECK(p.surface.triangleCount() > 0);
  }
  CHECK(bricks[0] == bricks[1]);
}

TEST_CASE("vertices at a wound follow particles on their own side, with weights that add up to 1") {
  for (int refine : {1, 2, 3}) {
    Patient p(test::blob(20), refine);
    const Vec3 normal = Vec3(0.2, 1, 0.3).normalized(), on = p.middle() + Vec3(0.001, 0.0012, 0);
    const Vec3 a = normal.unitOrthogonal();
    p.cut(test::flatBlade(on, 0.2 * a, 0.2 * normal.cross(a)));
    p.follow();
    p.surface.updateLook(p.field);
    int bound = 0, astray = 0, lips = 0, wrong = 0;
    p.surface.visitBindings([&](std::int32_t first, std::span<const VertexBinding> vertices) {
      for (std::size_t v = 0; v < vertices.size(); ++v) {
        const VertexBinding& b = vertices[v];
        ++bound;
        REQUIRE(b.count > 0);
        float sum = 0;
        int above = 0;
        for (int i = 0; i < b.count; ++i) {
          const std::int32_t cell = b.cell[std::size_t(i)];
          REQUIRE(p.particles[std::size_t(cell)]);
          sum += b.weight[std::size_t(i)];
          above += (p.field.lattice().centre(p.field.lattice().cell(cell)) - on).dot(normal) >= 0;
        }
        CHECK(std::abs(sum - 1) < 1e-5f);
        const bool mixed = above != 0 && above != b.count;
        astray += mixed;
        // A lip's normal looks across the cut, away from what the vertex follows.
        const std::size_t index = std::size_t(first) + v;
        if (p.surface.cut()[index] < 1 || mixed) continue;
        ++lips;
        const double side = p.surface.normals()[index].cast<double>().dot(normal);
        wrong += (side < 0) != (above > 0);
      }
    });
    MESSAGE("refine ", refine, ": ", bound, " vertices bound, ", lips, " on lips, ", astray,
            " follow both sides of a cut right through, ", wrong, " the other one");
    CHECK(astray == 0);
    CHECK(wrong <= lips / 1000);  // slivers without a particle follow the nearest
    CHECK(lips > 200);
  }
}

TEST_CASE(
    "behind the front of a cut each lip follows its own side; at the front vertices follow both") {
  for (int refine : {1, 2, 3}) {
    Patient p(test::blob(20), refine);
    const Vec3 normal = Vec3(0.1, 0.05, 1).normalized(), down = Vec3(0, 1, -0.05).normalized();
    const Vec3 across = normal.cross(down), front = p.middle() + Vec3(0.0011, 0.0007, 0.0013);
    // From the front upwards, out of the organ.
    p.cut(test::flatBlade(front + 0.1 * down, 0.2 * across, 0.1 * down));
    p.follow();
    p.surface.updateLook(p.field);
    int lips = 0, both = 0, late = 0;
    double farthest = 0;
    p.surface.visitBindings([&](std::int32_t first, std::span<const VertexBinding> vertices) {
      for (std::size_t v = 0; v < vertices.size(); ++v) {
        const std::size_t index = std::size_t(first) + v;
        if (p.surface.cut()[index] < 1) continue;
        const Vec3 at = p.surface.points()[index].cast<double>();
        int above = 0;
        for (int i = 0; i < vertices[v].count; ++i)
          above +=
              (p.field.lattice().centre(p.field.lattice().cell(vertices[v].cell[std::size_t(i)])) -
               front)
                  .dot(normal) >= 0;
        ++lips;
        if (above == 0 || above == vertices[v].count) continue;
        ++both;
        const double behind = (at - front).dot(down) / p.spacing();  // in cells
        farthest = std::max(farthest, behind);
        late += behind > 1;
      }
    });
    MESSAGE("refine ", refine, ": of ", lips, " lip vertices ", both,
            " follow both sides, the last of them ", farthest, " cells behind the front");
    CHECK(late == 0);
    CHECK(both > 0);
    CHECK(both < lips / 4);
  }
}

TEST_CASE("the skin's vertices at the rim of a cut are marked, and only they") {
  for (int refine : {1, 2, 3}) {
    Patient p(test::blob(20), refine);
    const Vec3 normal = Vec3(0.2, 1, 0.3).normalized(), on = p.middle() + Vec3(0.001, 0.0012, 0);
    const Vec3 a = normal.unitOrthogonal();
    p.follow();
    p.surface.updateLook(p.field);
    CHECK(std::ranges::count(p.surface.cut(), kRimShare) == 0);
    p.cut(test::flatBlade(on, 0.2 * a, 0.2 * normal.cross(a)));
    p.follow();
    p.surface.updateLook(p.field);
    int rim = 0;
    double farthest = 0;  // from the blade's plane, in cells
    for (std::size_t v = 0; v < p.surface.cut().size(); ++v) {
      if (p.surface.cut()[v] != kRimShare) continue;
      ++rim;
      const Vec3 at = p.surface.points()[v].cast<double>();
      farthest = std::max(farthest, std::abs((at - on).dot(normal)) / p.spacing());
    }
    MESSAGE("refine ", refine, ": ", rim, " at the rim, up to ", farthest, " cells off the plane");
    CHECK(rim > 40);
    CHECK(farthest < 0.4);
    const std::vector<float> exported = p.surface.compact().cut;
    CHECK(*std::ranges::min_element(exported) >= 0);
  }
}
