#include "organ/cell_labels.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numeric>

#include "base/error.h"
#include "organ/parts/bodies.h"
#include "organ/region_placer.h"
#include "organ/vertex_labels.h"
#include "support/blades.h"
#include "support/block_organ.h"

using namespace resect;

namespace {

Region lowerHalf() {  // along x
  Region region;
  region.frame = Region::Frame::Organ;
  region.box = {{-1, -1, -1}, {0.5, 2, 2}};
  return region;
}

std::int64_t labelled(const Discretization& cells, int label) {
  return labelledParticles(cells)[std::size_t(label)];
}

}  // namespace

TEST_CASE("fractions of the organ's box and world metres name the same cells at any spacing") {
  for (const int n : {6, 12, 24}) {
    Discretization cells = test::fullBlock({n, n / 2, n / 2}, 0.06 / n);
    CHECK(particleBox(cells).size().isApprox(Vec3(0.06, 0.03, 0.03)));
    Region world;
    world.box = {particleBox(cells).min, particleBox(cells).min + Vec3(0.03, 0.03, 0.03)};
    Discretization other = cells;
    CHECK(markCells(cells, 3, RegionPlacer(cells)(lowerHalf())) == n * n / 2 * n / 4);
    CHECK(markCells(other, 3, RegionPlacer(other)(world)) == n * n / 2 * n / 4);
    CHECK(cells.label == other.label);
  }
}

TEST_CASE("a ball round a landmark lies where the landmark does, and an unknown one is an error") {
  Discretization cells = test::fullBlock({20, 10, 10}, 0.002);
  cells.landmarks = {{"dome", {0.25, 0.5, 0.5}}};
  Region region;
  region.shape = Region::Shape::Ball;
  region.landmark = "dome";
  region.radius = 0.006;
  const Region placed = RegionPlacer(cells)(region);
  CHECK(placed.centre.isApprox(particleBox(cells).min + Vec3(0.01, 0.01, 0.01)));
  const std::int64_t marked = markCells(cells, 1, placed);
  const double ball = 4.0 / 3 * 3.14159265 * std::pow(0.006, 3);
  CHECK(double(marked) * cells.lattice.cellVolume() == doctest::Approx(ball).epsilon(0.1));
  region.landmark = "fundus";
  RegionPlacer place(cells);
  CHECK_THROWS_WITH_AS(place(region), "the organ has no landmark \"fundus\"; known are: dome",
                       Error);
}

TEST_CASE("depth counts from the surface inwards to a fraction of a cell") {
  Discretization cells = test::ball(40, 0.001);
  const Vec3 middle = cells.lattice.box().centre();
  const double radius = 0.019;
  Region region;
  region.shape = Region::Shape::Whole;
  region.shallowest = 0.004;
  region.deepest = 0.008;
  const Region placed = RegionPlacer(cells)(region);
  double worst = 0;  // of a particle that is told wrongly: from the edge of the shell, m
  int inShell = 0;
  for (std::int64_t c = 0; c < cells.lattice.cellCount(); ++c) {
    if (!cells.inside[std::size_t(c)]) continue;
    const Vec3 p = cells.lattice.centre(cells.lattice.cell(c));
    const double depth = radius - (p - middle).norm();
    const bool inside = depth >= 0.004 && depth <= 0.008;
    const double fromEdge = std::min(std::abs(depth - 0.004), std::abs(depth - 0.008));
    inShell += inside;
    if (inside != placed.holds(p)) worst = std::max(worst, fromEdge);
  }
  CHECK(inShell > 5000);
  // The surface of cells that were never fitted to the ball, and the distance's grid
  // of half cells.
  CHECK(worst < 0.0003);
  MESSAGE("a depth is told wrongly by ", worst / 0.001, " of a cell at most");
  region.shallowest = 0;
  const Region skin = RegionPlacer(cells)(region);
  Discretization marked = cells;
  markCells(marked, 1, skin);
  // Every particle on the outside belongs to the layer under the skin.
  for (std::int64_t c = 0; c < cells.lattice.cellCount(); ++c)
    if (cells.inside[std::size_t(c)] && cells.value[std::size_t(c)] < 100)
      CHECK(marked.label[std::size_t(c)] == 1);
}

TEST_CASE("skin cells outside have the label of the particle that they belong to") {
  Discretization cells = test::ball(16);
  markCells(cells, 5, RegionPlacer(cells)(lowerHalf()));
  labelSkin(cells);
  int skin = 0;
  for (std::int64_t c = 0; c < cells.lattice.cellCount(); ++c)
    if (!cells.inside[std::size_t(c)] && cells.value[std::size_t(c)] > 0) {
      ++skin;
      CHECK(cells.labelOf(c) == cells.labelOf(ownerCell(cells, c)));
    }
  CHECK(skin > 50);
}

TEST_CASE("labels, names and landmarks go over to finer cells of the same organ") {
  Discretization coarse = test::fullBlock({8, 4, 4}, 0.004);
  markCells(coarse, 2, RegionPlacer(coarse)(lowerHalf()));
  coarse.nameLabel(2, "tumour");
  coarse.landmarks = {{"dome", {0.5, 1, 0.5}}};
  Discretization fine = test::fullBlock({16, 8, 8}, 0.002);
  fine.lattice.origin = coarse.lattice.origin - Vec3::Constant(0.001);
  carryLabels(coarse, fine);
  CHECK(labelled(fine, 2) == 8 * labelled(coarse, 2));
  CHECK(fine.labelName(2) == "tumour");
  CHECK(fine.labelName(3) == "label 3");
  CHECK(fine.labelName(0) == "parenchyma");
  CHECK(landmarkPlace(fine.landmarks, "dome") == Vec3(0.5, 1, 0.5));
}

TEST_CASE("the tissue of a body is told by label and adds up") {
  Discretization cells = test::ball(16);
  markCells(cells, 5, RegionPlacer(cells)(lowerHalf()));
  labelSkin(cells);
  const Organ organ = makeOrgan(cells, {});
  const std::vector<Body> all = bodies(organ);
  REQUIRE(all.size() == 1);
  REQUIRE(all[0].tissueOf.size() == 6);
  CHECK(all[0].tissueOf[0] + all[0].tissueOf[5] == doctest::Approx(all[0].tissue));
  CHECK(all[0].tissueOf[0] == doctest::Approx(all[0].tissueOf[5]));
}

TEST_CASE("a vertex has the label of the nearest particle that is left") {
  Discretization cells = test::ball(16, 0.005);
  Organ plain = makeOrgan(cells, {});
  const std::vector<std::uint8_t> none = vertexLabels(plain);
  CHECK(none == std::vector<std::uint8_t>(plain.surface.points().size(), 0));

  markCells(cells, 5, RegionPlacer(cells)(lowerHalf()));
  labelSkin(cells);
  Organ organ = makeOrgan(cells, {});
  // A bite out of the upper side: its walls show what lies deeper.
  for (std::int64_t c = 0; c < cells.lattice.cellCount(); ++c) {
    const Vec3i at = cells.lattice.cell(c);
    if (cells.inside[std::size_t(c)] && at.y() > 9 && at.x() > 5 && at.x() < 11)
      removeParticle(organ, c);
  }
  const auto touched = updateField(organ);
  updateSurface(organ, touched);
  const std::vector<std::uint8_t> labels = vertexLabels(organ);
  REQUIRE(labels.size() == organ.surface.points().size());
  int seen[2] = {0, 0};
  for (const Triangle& t : organ.surface.triangles()) {
    if (t[0] == t[1]) continue;
    for (const auto v : t) {
      const Vec3 p = organ.surface.points()[std::size_t(v)].cast<double>();
      std::int64_t nearest = -1;
      double best = 1e9;
      for (std::int64_t c = 0; c < cells.lattice.cellCount(); ++c) {
        const double d = (cells.lattice.centre(cells.lattice.cell(c)) - p).squaredNorm();
        if (organ.alive[std::size_t(c)] && d < best) {
          best = d;
          nearest = c;
        }
      }
      const int label = organ.rest.labelOf(nearest);
      ++seen[label > 0];
      CHECK(int(labels[std::size_t(v)]) == label);
    }
  }
  CHECK(seen[0] > 100);
  CHECK(seen[1] > 100);
}

TEST_CASE("beside an incision a vertex has the label of its own side") {
  Discretization cells = test::fullBlock({12, 8, 8}, 0.005);
  markCells(cells, 1, RegionPlacer(cells)(lowerHalf()));
  Organ organ = makeOrgan(cells, {});
  // Between the two labels, all the way through.
  const Vec3 low = particleBox(cells).min, high = particleBox(cells).max;
  const double x = 0.5 * (low.x() + high.x());
  const SweptBlade blade = test::flatBlade(
      {x, 0.5 * (low.y() + high.y()), 0.5 * (low.z() + high.z())}, {0, 0.05, 0}, {0, 0, 0.05});
  CHECK(incise(organ, blade) > 0);
  updateSurface(organ, updateField(organ));
  const std::vector<std::uint8_t> labels = vertexLabels(organ);
  int lips[2] = {0, 0};
  for (const Triangle& t : organ.surface.triangles()) {
    if (t[0] == t[1]) continue;
    const auto at = [&](int k) { return organ.surface.points()[std::size_t(t[std::size_t(k)])]; };
    const Vec3f normal = (at(1) - at(0)).cross(at(2) - at(0));
    const bool lip = std::abs(at(0).x() - x) < 0.001 && std::abs(at(1).x() - x) < 0.001 &&
                     std::abs(at(2).x() - x) < 0.001 &&
                     std::abs(normal.x()) > 0.9f * normal.norm() && normal.norm() > 0;
    const bool middle = std::abs(at(0).y() - 0.5 * (low.y() + high.y())) < 0.01 &&
                        std::abs(at(0).z() - 0.5 * (low.z() + high.z())) < 0.01;
    if (!lip || !middle) continue;
    // The lip of the lower side looks up along x.
    const int label = normal.x() > 0;
    ++lips[label];
    for (const auto v : t) CHECK(int(labels[std::size_t(v)]) == label);
  }
  CHECK(lips[0] > 10);
  CHECK(lips[1] > 10);
}
