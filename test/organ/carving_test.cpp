// Carving: the surface lies on the instrument's path, whatever the cells; particles go by halves.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "base/random.h"
#include "geometry/measures.h"
#include "geometry/primitives.h"
#include "geometry/topology.h"
#include "organ/apply_edits.h"
#include "organ/builtin/builtin_liver.h"
#include "organ/carving.h"
#include "organ/discretize.h"
#include "organ/fit_surface.h"
#include "support/blades.h"
#include "support/block_organ.h"

using namespace resect;

namespace {

// A box of 90 x 60 x 90 mm, turned by an angle about an oblique axis, as an organ.
TriangleMesh turnedBox(double angle) {
  TriangleMesh mesh = boxMesh({{-0.045, -0.03, -0.045}, {0.045, 0.03, 0.045}});
  const Eigen::AngleAxisd turn(angle, Vec3(1, 2, 0.5).normalized());
  for (Vec3& p : mesh.points) p = turn * p + Vec3(0.0013, -0.0021, 0.0007);
  return mesh;
}

bool isClosedSkin(const TriangleMesh& mesh) {
  const Topology t = topology(mesh);
  return t.closed() && t.oriented() && t.manifold();
}

Organ organOf(const TriangleMesh& mesh, double spacing, int refine) {
  Discretization cells = discretize(mesh, latticeForSpacing(bounds(mesh), spacing));
  fitSurface(mesh, cells);
  OrganSettings settings;
  settings.refine = refine;
  return makeOrgan(std::move(cells), settings);
}

void carved(Organ& organ, const CarvedLine& line) {
  std::vector<std::int64_t> gone = carve(organ, line);
  for (const std::int64_t cell : gone) removeCarvedParticle(organ, cell);
  dropRemnants(organ, gone);
  updateSurface(organ, updateField(organ));
}

double volumeOf(const Organ& organ) { return volume(organ.surface.mesh()); }

CarvedLine randomLine(Random& random, const Aabb& box, double longest) {
  const auto share = [&] { return random.below(1001) / 1000.0; };
  const Vec3 from = box.min + box.size().cwiseProduct(Vec3(share(), share(), share()));
  const Vec3 along = Vec3(share() - 0.5, share() - 0.5, share() - 0.5) * longest;
  return {from, from + along, 0.002 + 0.006 * share()};
}

std::vector<TissueEdit> randomCarving(Random& random, const Organ& organ) {
  std::vector<TissueEdit> edits;
  for (int i = 0; i < 3; ++i)
    edits.push_back({0, -1, Carve{randomLine(random, organ.rest.lattice.box(), 0.03)}});
  edits.push_back({0, -1, RemoveCell{random.below(int(organ.alive.size()))}});
  return edits;
}

}  // namespace

TEST_CASE("a groove has the instrument's shape to a tenth of a cell, turned in any lattice") {
  for (const double angle : {0.0, 0.3, 0.8})
    for (const double spacing : {0.008, 0.005}) {
      CAPTURE(angle);
      CAPTURE(spacing);
      Organ organ = organOf(turnedBox(angle), spacing, 2);
      const double whole = volumeOf(organ);
      // From the middle of the upper face inwards, and then along: two cylinders with round ends.
      const Eigen::AngleAxisd turn(angle, Vec3(1, 2, 0.5).normalized());
      const auto at = [&](double x, double y, double z) -> Vec3 {
        return turn * Vec3(x, y, z) + Vec3(0.0013, -0.0021, 0.0007);
      };
      const double radius = 0.006;
      const CarvedLine down{at(-0.02, 0.05, 0), at(-0.02, 0.012, 0), radius},
          along{at(-0.02, 0.012, 0), at(0.02, 0.012, 0), radius};
      // As an instrument moves, a millimetre after the other.
      for (const CarvedLine& line : {down, along})
        for (int i = 0; i < 40; ++i) {
          const auto part = [&](int n) -> Vec3 {
            return line.from + n / 40.0 * (line.to - line.from);
          };
          carved(organ, {part(i), part(i + 1), radius});
        }
      REQUIRE(isClosedSkin(organ.surface.mesh()));
      double squares = 0, most = 0;
      int count = 0;
      for (const Vec3& p : organ.surface.mesh().points) {
        const double off = std::min(down.distance(p), along.distance(p));
        const Vec3 local = turn.inverse() * (p - Vec3(0.0013, -0.0021, 0.0007));
        if (local.y() > 0.024) continue;    // the rim of the hole
        if (off > 0.5 * spacing) continue;  // the box's faces
        squares += off * off, ++count;
        most = std::max(most, std::abs(off));
      }
      REQUIRE(count > 60);
      MESSAGE("off by ", 1e3 * std::sqrt(squares / count), " mm rms, ", 1e3 * most, " mm at most");
      CHECK(std::sqrt(squares / count) < 0.04 * spacing);
      CHECK(most < 0.12 * spacing);
      double cut = 0;  // what of the box lies in either cylinder, by points 0.5 mm apart
      const double step = 0.0005;
      for (double x = -0.03; x < 0.03; x += step)
        for (double y = 0; y < 0.03; y += step)
          for (double z = -0.01; z < 0.01; z += step) {
            const Vec3 p = at(x + 0.5 * step, y + 0.5 * step, z + 0.5 * step);
            if (std::min(down.distance(p), along.distance(p)) < 0) cut += step * step * step;
          }
      MESSAGE("takes ", 1e6 * (whole - volumeOf(organ)), " ml of ", 1e6 * cut);
      // The rim of the hole is rounded by the cells.
      CHECK(std::abs((whole - volumeOf(organ)) / cut - 1) < 10 * spacing);
      CHECK(organ.removedVolume > 0);
    }
}

TEST_CASE("caps on the default cells follow the instrument better than finer cells do") {
  // Decision 27: an instrument is drawn 40 mm over the dome of the liver, a millimetre at a time.
  struct Trial {
    double radius, below;  // m: of the instrument; of its middle, below the skin
  };
  for (const Trial& trial : {Trial{0.006, 0.003}, Trial{0.0035, 0.002}}) {
    std::vector<Vec3> way;
    for (int i = 0; i <= 40; ++i) {
      Vec3 p(-0.06 + 0.0009 * i, 0.15, 0.01 + 0.00043 * i);
      while (builtinLiverDistance(p) > 0) p.y() -= 2e-4;
      way.push_back(p - Vec3(0, trial.below, 0));
    }
    const auto off = [&](const Vec3& p) {
      double least = 1;
      for (std::size_t i = 1; i < way.size(); ++i)
        least = std::min(least, CarvedLine{way[i - 1], way[i], trial.radius}.distance(p));
      return least;
    };
    const auto wound = [&](double spacing, int refine, bool caps) {
      Organ organ = organOf(builtinLiver(), spacing, refine);
      const double whole = volumeOf(organ);
      for (std::size_t i = 1; i < way.size(); ++i) {
        const CarvedLine line{way[i - 1], way[i], trial.radius};
        if (caps) {
          carved(organ, line);
          continue;
        }
        visitCellsIn(organ.rest.lattice, line.bounds(), [&](const Vec3i& at) {
          const std::int64_t cell = organ.rest.lattice.index(at);
          if (organ.alive[std::size_t(cell)] && line.distance(organ.rest.lattice.centre(at)) <= 0)
            removeParticle(organ, cell);
        });
        updateSurface(organ, updateField(organ));
      }
      double squares = 0, most = 0;
      int count = 0;
      for (const Vec3& p : organ.surface.mesh().points) {
        if (builtinLiverDistance(p) > -0.0025 || std::abs(off(p)) > 0.006) continue;
        squares += off(p) * off(p), ++count;
        most = std::max(most, std::abs(off(p)));
      }
      REQUIRE(count > 20);
      const double rms = std::sqrt(squares / count);
      MESSAGE("radius ", 1e3 * trial.radius, " mm, ", std::string(caps ? "caps" : "whole cells"),
              ", spacing ", 1e3 * spacing, " mm, ", refine, " nodes a cell: off by ", 1e3 * rms,
              " mm rms, ", 1e3 * most, " mm at most; takes ", 1e6 * (whole - volumeOf(organ)),
              " ml");
      return rms;
    };
    const double coarse = wound(0.008, 2, false), finer = wound(0.0025, 1, false);
    wound(0.005, 2, false), wound(0.00125, 1, false);
    CHECK(finer < coarse);
    CHECK(wound(0.008, 2, true) < 0.6 * finer);
    CHECK(wound(0.005, 2, true) < 0.3 * finer);
  }
}

TEST_CASE("the particles that go have the volume that the surface loses, where much is carved") {
  for (const double angle : {0.0, 0.4, 0.9}) {
    CAPTURE(angle);
    Organ organ = organOf(turnedBox(angle), 0.005, 2);
    const double before = volumeOf(organ);
    // A hole of some 46 x 18 x 46 mm, by an instrument of 8 mm radius that goes to and fro.
    const Eigen::AngleAxisd turn(angle, Vec3(1, 2, 0.5).normalized());
    for (double y = 0.032; y > 0.018; y -= 0.006)
      for (double z = -0.015; z <= 0.0151; z += 0.006) {
        carved(organ, {turn * Vec3(-0.015, y, z), turn * Vec3(0.015, y, z), 0.008});
      }
    const double surface = before - volumeOf(organ);
    MESSAGE("particles ", 1e6 * organ.removedVolume, " ml, surface ", 1e6 * surface, " ml");
    CHECK(std::abs(organ.removedVolume / surface - 1) < 0.09);
  }
}

TEST_CASE("carved in any order, the surface stays closed and equals a rebuild bit for bit") {
  for (const int refine : {1, 2, 3, 4}) {
    CAPTURE(refine);
    OperatedOrgan operated = operatedOrgan("ball", makeOrgan(test::ball(16), {refine, 50}));
    Organ& organ = operated.organ;
    Random random(std::uint64_t(40 + refine));
    for (int step = 0; step < 40; ++step) {
      std::vector<std::int64_t> removed;
      std::vector<TissueEdit> edits = randomCarving(random, organ);
      if (step % 4 == 3)
        edits.push_back({0, -1,
                         Incision{test::randomBlade(organ.rest.lattice.box().centre(), 0.02,
                                                    organ.rest.lattice.spacing.x(), random)}});
      applyEdits(operated, 0, edits, removed);
      updateSurface(organ, updateField(organ));
      const Wound wound{organ.severed, organ.alive, organ.kerf};
      const TriangleMesh mesh = organ.surface.mesh();
      const TriangleMesh anew = organ.severed.empty()
                                    ? SurfaceTracker(organ.field, 50).mesh()
                                    : SurfaceTracker(organ.field, 50, &wound).mesh();
      REQUIRE(mesh.points == anew.points);
      REQUIRE(mesh.triangles == anew.triangles);
      if (organ.severed.empty()) REQUIRE(isClosedSkin(mesh));
      // The field is that of the present cells and caps, evaluated in any order.
      Discretization now = organ.rest;
      for (std::int64_t c = 0; c < now.lattice.cellCount(); ++c)
        now.value.set(c, organ.field.cellValue(c));
      ColourField fresh(now, refine);
      fresh.capsRestored(organ.carved);
      fresh.update(organ.carved);
      const Vec3i nodes = fresh.nodeDims();
      bool same = true;
      for (int z = 0; z < nodes.z(); ++z)
        for (int y = 0; y < nodes.y(); ++y)
          for (int x = 0; x < nodes.x(); ++x)
            same = same && fresh.node({x, y, z}) == organ.field.node({x, y, z});
      REQUIRE(same);
    }
    CHECK(organ.removed > 100);
    CHECK(std::ranges::count(organ.remnant, 1) > 10);
  }
}

TEST_CASE("when all is carved away nothing is left: no particle, no remnant, no surface") {
  OperatedOrgan operated = operatedOrgan("ball", makeOrgan(test::ball(10), {}));
  Organ& organ = operated.organ;
  const Aabb box = organ.rest.lattice.box();
  const Vec3 middle = box.centre();
  std::vector<std::int64_t> removed;
  const double reach = 0.5 * box.size().maxCoeff();
  for (double x = -reach; x <= reach; x += 0.003) {
    const Vec3 side(x, 0, 0), up(0, 0.6 * reach, 0);
    for (const double z : {-0.8, 0.0, 0.8}) {
      const Vec3 there = middle + side + Vec3(0, 0, z * reach);
      const TissueEdit edit{0, -1, Carve{{there - up, there + up, reach}}};
      removed.clear();
      applyEdits(operated, 0, {&edit, 1}, removed);
      updateSurface(organ, updateField(organ));
    }
  }
  CHECK(organ.particles == 0);
  CHECK(organ.removedVolume == doctest::Approx(organ.rest.volume()));
  CHECK(std::ranges::count(organ.remnant, 1) == 0);
  CHECK(organ.surface.mesh().triangles.empty());
}

TEST_CASE("tissue beyond the instrument's reach is not touched, and a carving in the air is none") {
  Organ organ = organOf(turnedBox(0.2), 0.005, 2);
  const TriangleMesh before = organ.surface.mesh();
  carved(organ, {{0.2, 0.2, 0.2}, {0.21, 0.2, 0.2}, 0.01});
  carved(organ, {{0, 0.07, 0}, {0.01, 0.07, 0}, 0.01});
  CHECK(organ.carved.empty());
  CHECK(organ.surface.mesh().points == before.points);
}
