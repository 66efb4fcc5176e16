#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>

#include "geometry/measures.h"
#include "support/blades.h"
#include "support/block_organ.h"
#include "support/references/wound_reference.h"
#include "wound/blade_raster.h"

using namespace resect;

namespace {

constexpr int kCells = 32;

// An organ at rest under the knife; lengths in node spacings.
struct Case {
  Discretization cells;
  ColourField field;
  SeveredEdges severed;
  test::GridOrgan organ;
  TriangleMesh base;
  double whole;

  explicit Case(Discretization d, int refine = 1)
      : cells(std::move(d)),
        field(cells, refine),
        severed(field.brickDims(), field.refine()),
        organ(field.nodeDims()) {
    organ.fill([&](const Vec3i& n) { return field.node(n); });
    base = test::tableMesh(organ.view());
    whole = volume(base);
  }
  Vec3 toGrid(const Vec3& p) const {
    return (p - field.nodePosition(Vec3::Zero()))
        .cwiseQuotient(field.nodePosition(Vec3::Ones()) - field.nodePosition(Vec3::Zero()));
  }
  Vec3 at(double x, double y, double z) const { return field.nodePosition({x, y, z}); }
  // A vector of so many node spacings.
  Vec3 by(double x, double y, double z) const { return at(x, y, z) - at(0, 0, 0); }
  // Whether a place (node spacings) is less than a node away from the skin.
  bool nearSkin(const Vec3& p) const {
    for (int z = -1; z <= 2; ++z)
      for (int y = -1; y <= 2; ++y)
        for (int x = -1; x <= 2; ++x)
          if (field.node(p.array().floor().matrix().cast<int>() + Vec3i(x, y, z)) < 50) return true;
    return false;
  }
  void cut(const SweptBlade& blade) {
    severAtRest(severed, field, 50, blade);
    organ.take(severed);
  }
  test::WoundMesh checked() {
    const CutGrid grid = organ.view(&severed);
    test::WoundMesh surface = test::woundMesh(grid);
    REQUIRE(test::wrongWith(surface.mesh) == "");
    REQUIRE(test::bridges(surface, grid) == 0);
    CHECK(surface.unbalanced == 0);
    CHECK(std::abs(volume(surface.mesh) / whole - 1) < 1e-9);
    return surface;
  }
  std::vector<double> pieces(const test::WoundMesh& surface) const {
    return test::pieceVolumes(surface, organ.view(&severed), 1e-6);
  }
};

// Volume of a closed mesh on the side of the plane to which `normal` points.
double volumeBeyond(const TriangleMesh& mesh, const Vec3& onPlane, const Vec3& normal) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    std::vector<Vec3> kept;
    for (std::size_t v = 0; v < 3; ++v) {
      const Vec3 a = mesh.points[std::size_t(t[v])] - onPlane,
                 b = mesh.points[std::size_t(t[(v + 1) % 3])] - onPlane;
      const double ha = a.dot(normal), hb = b.dot(normal);
      if (ha >= 0) kept.push_back(a);
      if ((ha >= 0) != (hb >= 0)) kept.push_back(a + ha / (ha - hb) * (b - a));
    }
    for (std::size_t k = 1; k + 1 < kept.size(); ++k)
      sum += kept[0].dot(kept[k].cross(kept[k + 1])) / 6;
  }
  return sum;
}

// Root mean square and greatest distance of the lips' points from the plane.
std::pair<double, double> offPlane(const test::WoundMesh& surface, const Vec3& on,
                                   const Vec3& normal) {
  double sum = 0, most = 0;
  int count = 0;
  for (std::size_t t = 0; t < surface.mesh.triangles.size(); ++t) {
    if (!surface.onLip[t]) continue;
    for (const auto p : surface.mesh.triangles[t]) {
      const double d = std::abs((surface.mesh.points[std::size_t(p)] - on).dot(normal));
      sum += d * d;
      most = std::max(most, d);
      ++count;
    }
  }
  return {std::sqrt(sum / std::max(count, 1)), most};
}

// Number of connected parts of the lips.
int lipsOf(const test::WoundMesh& surface) {
  std::vector<std::size_t> part(surface.mesh.points.size());
  std::iota(part.begin(), part.end(), std::size_t(0));
  const auto root = [&](std::size_t p) {
    while (part[p] != p) p = part[p] = part[part[p]];
    return p;
  };
  for (std::size_t t = 0; t < surface.mesh.triangles.size(); ++t)
    if (surface.onLip[t])
      for (const std::int32_t p : surface.mesh.triangles[t])
        part[root(std::size_t(p))] = root(std::size_t(surface.mesh.triangles[t][0]));
  std::set<std::size_t> parts;
  for (std::size_t t = 0; t < surface.mesh.triangles.size(); ++t)
    if (surface.onLip[t]) parts.insert(root(std::size_t(surface.mesh.triangles[t][0])));
  return int(parts.size());
}

}  // namespace

TEST_CASE("a cut right through leaves two closed pieces with the volumes of an exact cut") {
  int clean = 0;
  for (int plane = 0; plane < 6; ++plane) {
    Case c(test::blob(kCells));
    const Vec3 normal = Vec3(0.3, 0.9 - 0.23 * plane, 0.2 + 0.11 * plane).normalized();
    const Vec3 middle = c.at(17.3, 18.1 + plane, 17.7), a = normal.unitOrthogonal();
    c.cut(test::flatBlade(middle, 0.2 * a, 0.2 * normal.cross(a), 3, 3));
    const auto surface = c.checked();
    const auto pieces = c.pieces(surface);
    REQUIRE(pieces.size() >= 2);
    // Where the organ is thinner than the grid, corners can be cut off from all their neighbours.
    const double crumbs = std::accumulate(pieces.begin(), pieces.end() - 2, 0.0);
    const double above = volumeBeyond(c.base, c.toGrid(middle), normal);
    const double least = std::min(above, c.whole - above), small = *(pieces.end() - 2);
    const auto [rms, most] = offPlane(surface, c.toGrid(middle), normal);
    MESSAGE(surface.cutCells, " cut cells; pieces ", crumbs, " (crumbs), ", small, " and ",
            pieces.back(), ", exact ", least, " and ", c.whole - least, "; lips off the blade rms ",
            rms, " greatest ", most);
    CHECK(crumbs < 1);
    // At the rim slivers thinner than the grid change sides.
    CHECK(std::abs(small - least) < 2e-4 * c.whole);
    if (crumbs > 0) continue;
    ++clean;
    CHECK(rms < 0.02);
    CHECK(most < 0.5);
  }
  CHECK(clean >= 4);
}

TEST_CASE("a cut that ends in tissue leaves one piece, and its front lies at the blade's edge") {
  Case c(test::blob(kCells));
  // From above down to y = 17.4 in grid units, in an oblique plane.
  const Vec3 along = Vec3(1, 0, 0.35).normalized();
  const double depth = 17.4;
  const Vec3 middle = c.at(18, depth, 17.6);
  const double h = c.by(1, 0, 0).x();
  c.cut(test::patch(
      [&](double u, double v) {
        return Vec3(middle + (40 * u - 20) * h * along + Vec3(0, (25 - 25 * v) * h, 0));
      },
      5, 5));
  const auto surface = c.checked();
  CHECK(c.pieces(surface).size() == 1);
  double worst = 0, worstAtSkin = 0, sum = 0;
  int fronts = 0;
  for (std::size_t p = 0; p < surface.tip.size(); ++p)
    if (surface.tip[p] && std::abs(surface.mesh.points[p].y() - depth) < 1.5) {
      const double off = std::abs(surface.mesh.points[p].y() - depth);
      double& most = c.nearSkin(surface.mesh.points[p]) ? worstAtSkin : worst;
      most = std::max(most, off);
      sum += off;
      ++fronts;
    }
  MESSAGE(surface.cutCells, " cut cells; ", fronts, " points of the front, ", sum / fronts,
          " from the blade's edge in the mean, at most ", worst, ", at the skin ", worstAtSkin);
  CHECK(fronts > 15);
  CHECK(worst < 0.05);
  CHECK(worstAtSkin < 1);  // there the cut is continued to the next edge in tissue
}

TEST_CASE("a shallow cut opens the skin in one line, however deep it is and however it lies") {
  Random random(7);
  int strokes = 0, whole = 0;
  for (const double depth : {0.3, 0.6, 0.9, 1.5, 3.0})  // node spacings
    for (int turn = 0; turn < 8; ++turn) {
      Case c(test::ball(kCells));
      const double h = c.by(1, 0, 0).x();
      const Vec3 middle = c.field.lattice().box().centre();
      const double radius = std::cbrt(3 * c.whole / (4 * std::numbers::pi)) * h;
      const Vec3 across = test::randomDirection(random), along = across.unitOrthogonal();
      // In steps, as a hand draws it: an arc of 90 degrees.
      constexpr int kSteps = 90;
      const auto edge = [&](int step, double height) {
        const double angle = 0.5 * std::numbers::pi * step / kSteps;
        return Vec3(middle + (radius + height * h) *
                                 (std::cos(angle) * along + std::sin(angle) * across.cross(along)));
      };
      for (int i = 0; i < kSteps; ++i) {
        const Vec3 before[] = {edge(i, -depth), edge(i, 3)},
                   after[] = {edge(i + 1, -depth), edge(i + 1, 3)};
        c.cut(ruledBlade(before, after));
      }
      const auto surface = c.checked();
      const int lines = lipsOf(surface);
      MESSAGE("depth ", depth, ": ", lines, " lines");
      ++strokes, whole += lines == 1;
    }
  CHECK(whole == strokes);
}

TEST_CASE("a curved cut leaves two lips on the blade") {
  Case c(test::blob(kCells));
  const double h = c.by(1, 0, 0).x();
  c.cut(test::patch(
      [&](double u, double v) {
        return Vec3(c.at(3 + 31 * u, 17.2, 17.9) +
                    Vec3(0, 20 * h * (1 - v), 3 * h * std::sin(5 * u)));
      },
      16, 4));
  const auto surface = c.checked();
  CHECK(c.pieces(surface).size() == 1);
  double most = 0;
  for (std::size_t p = 0; p < surface.sheet.size(); ++p)
    if (surface.sheet[p]) {
      const Vec3& q = surface.mesh.points[p];
      most = std::max(most, std::abs(q.z() - 17.9 - 3 * std::sin(5 * (q.x() - 3) / 31)));
    }
  MESSAGE("lips off the curve by at most ", most);
  CHECK(most < 0.15);  // the blade itself is 16 flat strips
}

TEST_CASE("crossing, re-entering, blind, grazing and corner cuts close and keep the volume") {
  SUBCASE("two that cross make four pieces") {
    Case c(test::blob(kCells));
    c.cut(test::flatBlade(c.at(17.4, 17.6, 18.2), c.by(30, 0, 0), c.by(0, 3, 30)));
    c.cut(test::flatBlade(c.at(17.4, 17.6, 18.2), c.by(3, 30, 2), c.by(0, 0, 30)));
    c.cut(test::flatBlade(c.at(18.4, 14.6, 16.2), c.by(20, 20, 0), c.by(0, 6, -9)));
    const auto surface = c.checked();
    CHECK(c.pieces(surface).size() >= 4);
  }
  SUBCASE("one that comes back beside itself") {
    Case c(test::blob(kCells));
    c.cut(test::flatBlade(c.at(17.4, 28, 17.2), c.by(9, 0, 2), c.by(0, 9, 0)));
    c.cut(test::flatBlade(c.at(19.4, 27, 18.4), c.by(9, 0, -4), c.by(0, 9, 3)));
    c.checked();
  }
  SUBCASE("one within, that meets no skin: a pocket without volume") {
    Case c(test::blob(kCells));
    c.cut(test::flatBlade(c.at(17.4, 17.6, 18.2), c.by(5, 1, 0), c.by(0, 5, 2)));
    const auto surface = c.checked();
    CHECK(c.pieces(surface).size() == 1);
    CHECK(surface.cutCells > 50);
  }
  SUBCASE("one exactly through the nodes") {
    Case c(test::blob(kCells));
    c.cut(test::flatBlade(c.at(17, 17, 17), c.by(30, 0, 0), c.by(0, 0, 30)));
    CHECK(c.pieces(c.checked()).size() == 2);
    Case diagonal(test::blob(kCells));
    diagonal.cut(
        test::flatBlade(diagonal.at(17, 17, 17), diagonal.by(30, 30, 0), diagonal.by(0, 0, 30)));
    CHECK(diagonal.pieces(diagonal.checked()).size() == 2);
    Case through(test::blob(kCells));
    through.cut(
        test::flatBlade(through.at(17, 17, 17), through.by(20, -20, 0), through.by(10, 10, -20)));
    CHECK(through.pieces(through.checked()).size() == 2);
  }
  SUBCASE("a shallow slice that leaves the skin under a flat angle") {
    Case c(test::blob(kCells));
    double top = 0;
    for (const Vec3& p : c.base.points) top = std::max(top, p.y());
    c.cut(test::flatBlade(c.at(18, top - 1.4, 18), c.by(20, 0.6, 0), c.by(0, 0.4, 20)));
    CHECK(c.pieces(c.checked()).size() == 2);
  }
  SUBCASE("a cup scooped out") {
    Case c(test::blob(kCells));
    const double h = c.by(1, 0, 0).x();
    double top = 0;
    for (const Vec3& p : c.base.points) top = std::max(top, p.y());
    c.cut(test::patch(
        [&](double u, double v) {
          const double angle = 2 * std::numbers::pi * u, r = 7 * std::sin(1.9 * v);
          return Vec3(c.at(18.2, top - 1, 17.7) +
                      h * Vec3(r * std::cos(angle), -7 * std::cos(1.9 * v), r * std::sin(angle)));
        },
        24, 10));
    CHECK(c.pieces(c.checked()).size() == 2);
  }
}

TEST_CASE("four hundred sets of random blades close, keep the volume and bridge nothing") {
  int cells = 0;
  double worst = 0;
  for (int run = 0; run < 400; ++run) {
    INFO("run ", run);
    Random random(std::uint64_t(1000 + run));
    Case c(test::blob(12 + run % 5, 0.005), 1 + (run % 8 == 0));
    const Vec3 middle = c.field.lattice().box().centre();
    const double size = 0.5 * c.field.lattice().box().size().x();
    const int blades = 1 + random.below(4);
    for (int b = 0; b < blades; ++b)
      c.cut(test::randomBlade(middle, size, c.field.lattice().spacing.x(), random));
    const auto surface = c.checked();
    cells += surface.cutCells;
    worst = std::max(worst, std::abs(volume(surface.mesh) / c.whole - 1));
  }
  MESSAGE(cells, " cut cells; largest relative change of volume ", worst);
}

TEST_CASE("while a blade advances in small steps the wound closes at each and its front keeps up") {
  Case c(test::blob(20));
  const double h = c.by(1, 0, 0).x();
  double lag = 0, jump = 0, last = 0;
  const auto edge = [&](double u, double depth) {
    return Vec3(c.at(1 + 22 * u, 24 - depth, 11.3 + 2 * u) +
                Vec3(0, -0.15 * h * std::sin(9 * u), 0));
  };
  for (int step = 0; step < 180; ++step) {
    INFO("step ", step);
    const double from = 0.1 * step, to = 0.1 * (step + 1);
    c.cut(test::patch([&](double u, double v) { return edge(u, from + v * (to - from)); }, 8, 1));
    if (step % 3 != 2) continue;  // the plain mesher is slow
    const auto surface = c.checked();
    double front = 1e9;
    for (std::size_t p = 0; p < surface.tip.size(); ++p)
      if (surface.tip[p] || surface.sheet[p]) front = std::min(front, surface.mesh.points[p].y());
    if (front > 1e8) continue;
    const double blade = 24 - to - 0.15;
    lag = std::max(lag, front - blade);
    if (last > 0) jump = std::max(jump, last - front);
    last = front;
  }
  MESSAGE("front behind the blade's edge by at most ", lag, ", moved by at most ", jump,
          " in three steps of 0.1");
  CHECK(lag < 0.5);
}
