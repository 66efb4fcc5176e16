// The ledger against what can be reckoned by hand: planes through balls and boxes, still and
// elastic, straight and askew in the lattice.
#include "operation/ledger/ledger.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "geometry/primitives.h"
#include "operation/ledger/ledger_watch.h"
#include "operation/ledger/wound_faces.h"
#include "organ/cell_labels.h"
#include "organ/discretize.h"
#include "support/block_organ.h"
#include "support/cuts.h"
#include "support/sentence.h"
#include "tissue/elastic/elastic_tissue.h"

using namespace resect;
using test::Plane;

namespace {

constexpr double kPi = std::numbers::pi;

double apart(double a, double b) { return std::abs(a / b - 1); }

Simulation simulationOf(Discretization cells, bool elastic) {
  std::unique_ptr<TissueModel> tissue;
  if (elastic)
    tissue = std::make_unique<ElasticTissue>(
        TissueCells{cells.lattice, cells.inside, {TissueMaterial{}}, {}}, TissueSettings{});
  return Simulation(makeOrgan(std::move(cells), {}), {}, std::move(tissue), false);
}

Discretization cellsOf(const TriangleMesh& mesh, double spacing) {
  return discretize(mesh, latticeForSpacing(bounds(mesh), spacing));
}

Ledger ledgerOf(const Simulation& simulation) {
  const Ledger ledger = LedgerBooks(std::vector<TissueSetup>(1), simulation).ledgerOf(simulation);
  CHECK(discrepancy(ledger, &simulation) == "");
  return ledger;
}

// Planes along the lattice and askew.
std::vector<Vec3> normals() {
  Random random(5);
  std::vector<Vec3> all{Vec3::UnitX(), Vec3::UnitZ(), Vec3(1, 1, 0).normalized(),
                        Vec3(1, 1, 1).normalized()};
  for (int i = 0; i < 4; ++i) all.push_back(test::randomDirection(random));
  return all;
}

// Area of the section of a box, turned about its centre, by a plane, from many points of the plane.
double sectionOfBox(const Vec3& centre, const Vec3& half, const Mat3& turn, const Plane& plane) {
  const Vec3 a = plane.normal.unitOrthogonal(), b = plane.normal.cross(a);
  const Vec3 foot = centre + (plane.offset - plane.normal.dot(centre)) * plane.normal;
  constexpr int kSteps = 800;
  const double far = 1.8 * half.maxCoeff(), step = 2 * far / kSteps;
  double area = 0;
  for (int i = 0; i < kSteps; ++i)
    for (int k = 0; k < kSteps; ++k) {
      const Vec3 p = foot + ((i + 0.5) * step - far) * a + ((k + 0.5) * step - far) * b;
      if (((turn.transpose() * (p - centre)).cwiseAbs().array() <= half.array()).all())
        area += step * step;
    }
  return area;
}

}  // namespace

TEST_CASE("the area of a plane cut through a ball is that of the circle, within 3 %") {
  const double radius = 0.05;
  double worst = 0;
  for (const Vec3& shift : {Vec3(0, 0, 0), Vec3(0.0011, 0.0007, 0.0017)})
    for (const Vec3& normal : normals())
      for (const double offset : {0.0, 0.0123, 0.03}) {
        const Vec3 centre = Vec3(0.02, 0.1, -0.03) + shift;
        Aabb box = bounds(sphereMesh(centre, radius, 48));
        box.min -= shift;  // so that the lattice lies otherwise in the ball
        for (const bool elastic : {false, true}) {
          if (elastic && offset != 0.0123) continue;
          Simulation simulation = simulationOf(
              discretize(sphereMesh(centre, radius, 48), latticeForSpacing(box, 0.004)), elastic);
          test::cutAlong(simulation, {normal, normal.dot(centre) + offset});
          const OrganLedger ledger = ledgerOf(simulation).organs[0];
          const double exact = kPi * (radius * radius - offset * offset);
          CAPTURE(elastic);
          CAPTURE(offset);
          CAPTURE(normal.transpose());
          worst = std::max(worst, std::abs(ledger.cut / exact - 1));
          CHECK(apart(ledger.cut, exact) < 0.03);
          CHECK(ledger.bared == 0);
          REQUIRE(ledger.parts.size() == 2);
          const double h = radius - offset, cap = kPi * h * h * (3 * radius - h) / 3;
          // In whole cells.
          CHECK(std::abs(ledger.tissue.left().volume - ledger.tissue.body.volume - cap) <
                0.8 * 0.004 * exact);
        }
      }
  MESSAGE("worst error of the area ", 100 * worst, " %");
}

TEST_CASE("the area of a plane cut through a box is that of its section, within 3 %") {
  const Vec3 half(0.05, 0.03, 0.04);
  double worst = 0;
  Random random(3);
  for (int i = 0; i < 12; ++i) {
    const bool turned = i % 3 != 0;
    const Mat3 turn =
        turned ? Eigen::AngleAxisd(random.uniform(0.2, 1.3), test::randomDirection(random))
                     .toRotationMatrix()
               : Mat3(Mat3::Identity());
    const Vec3 centre = 0.01 * test::randomDirection(random);
    TriangleMesh mesh = boxMesh({-half, half});
    for (Vec3& p : mesh.points) p = turn * p + centre;
    const Vec3 normal = i % 4 == 0 ? Vec3(turn.col(0)) : test::randomDirection(random);
    const Plane plane{normal, normal.dot(centre) + random.uniform(-0.01, 0.01)};
    Simulation simulation = simulationOf(cellsOf(mesh, 0.004), i % 2 == 1);
    test::cutAlong(simulation, plane);
    const double exact = sectionOfBox(centre, half, turn, plane);
    const double cut = ledgerOf(simulation).organs[0].cut;
    worst = std::max(worst, std::abs(cut / exact - 1));
    CAPTURE(i);
    CHECK(apart(cut, exact) < 0.03);
  }
  MESSAGE("worst error of the area ", 100 * worst, " %");
}

TEST_CASE("a removed slab bares its two sides and is no cut") {
  const double radius = 0.05;
  for (const Vec3& normal : normals()) {
    Simulation simulation = simulationOf(cellsOf(sphereMesh({0, 0, 0}, radius, 48), 0.004), false);
    const Lattice& lattice = simulation.organ().rest.lattice;
    FrameInput input;
    for (std::int64_t c = 0; c < lattice.cellCount(); ++c)
      if (std::abs(normal.dot(lattice.centre(lattice.cell(c)))) < 0.012)
        input.edits.push_back({0, -1, RemoveCell{c}});
    simulation.step(input);
    const OrganLedger ledger = ledgerOf(simulation).organs[0];
    CHECK(ledger.cut == 0);
    CHECK(apart(ledger.bared, 2 * kPi * (radius * radius - 0.012 * 0.012)) < 0.07);
    CHECK(ledger.parts.size() == 2);
    CHECK(ledger.tissue.removed.volume > 0);
  }
}

TEST_CASE("the margin of a ball within a ball is its distance from the plane of a cut") {
  // The ball is 12 cells wide; half a cell is 6 % of a distance of 8 cells.
  const double radius = 0.06, inner = 0.015, spacing = 0.0025;
  double worst = 0, worstCells = 0;
  for (const Vec3& shift : {Vec3(0, 0, 0), Vec3(0.0011, 0.0007, 0.0017)})
    for (const Vec3& normal : normals()) {
      const TriangleMesh mesh = sphereMesh({0, 0, 0}, radius, 48);
      Aabb box = bounds(mesh);
      box.min -= shift;
      Discretization cells = discretize(mesh, latticeForSpacing(box, spacing));
      Region region;
      region.shape = Region::Shape::Ball;
      region.radius = inner;
      markCells(cells, 3, region);
      labelSkin(cells);
      cells.nameLabel(3, "tumour");
      for (const double offset : {0.025, 0.0325, 0.0413}) {
        Simulation simulation = simulationOf(cells, false);
        CHECK(std::isinf(*ledgerOf(simulation).organs[0].labels[1].margin));
        test::cutAlong(simulation, {normal, offset});
        const double margin = *ledgerOf(simulation).organs[0].labels[1].margin;
        const std::vector<MarginPlace> places =
            marginPlaces(simulation.organ(), Structure(cells, 3), margin + 0.01);
        REQUIRE(places.size() > 20);
        double least = 1;
        for (const MarginPlace& one : places) {
          CHECK(std::abs(normal.dot(one.place) - offset) < spacing);
          CHECK(std::abs(one.distance - (one.place.norm() - inner)) < 0.5 * spacing);
          least = std::min(least, one.distance);
        }
        CHECK(std::abs(least - margin) < 0.25 * spacing);
        const double error = std::abs(margin - (offset - inner));
        worstCells = std::max(worstCells, error / spacing);
        // Of a face along the lattice, cells do not tell where it lies between them.
        if (offset - inner > 0.02 && std::abs(normal.maxCoeff() - 1) > 1e-9) {
          worst = std::max(worst, error / (offset - inner));
          CHECK(apart(margin, offset - inner) < 0.03);
        }
      }
      Simulation simulation = simulationOf(cells, false);
      test::cutAlong(simulation, {normal, 0.005});
      CHECK(*ledgerOf(simulation).organs[0].labels[1].margin == 0);
    }
  MESSAGE("worst error of the margin ", 100 * worst, " %, ", worstCells, " cells");
  CHECK(worstCells < 0.5);
}

TEST_CASE(
    "faces that removed tissue has bared count for the margin; removed tissue of the structure "
    "leaves none") {
  Discretization cells = test::fullBlock({30, 12, 12}, 0.002);
  cells.label.assign(std::size_t(cells.lattice.cellCount()), 0);
  for (std::int64_t c = 0; c < cells.lattice.cellCount(); ++c)
    if (cells.lattice.cell(c).x() < 6) cells.label[std::size_t(c)] = 2;
  cells.nameLabel(2, "bed");
  Simulation simulation = simulationOf(cells, false);
  const auto remove = [&](int from, int to) {
    FrameInput input;
    for (std::int64_t c = 0; c < cells.lattice.cellCount(); ++c)
      if (const int x = cells.lattice.cell(c).x(); x >= from && x < to)
        input.edits.push_back({0, -1, RemoveCell{c}});
    simulation.step(input);
  };
  remove(20, 24);
  OrganLedger ledger = ledgerOf(simulation).organs[0];
  REQUIRE(ledger.labels.size() == 2);
  CHECK(std::abs(*ledger.labels[1].margin - 14 * 0.002) < 0.5 * 0.002);
  CHECK(ledger.parts.size() == 2);
  CHECK(ledger.parts[1].tissue.particles == 6 * 144);
  CHECK(ledger.labels[1].tissue.body.particles == 6 * 144);
  remove(5, 7);
  CHECK(*ledgerOf(simulation).organs[0].labels[1].margin == 0);
}

TEST_CASE("parts are what bonds connect, still and elastic alike, across slits without width") {
  for (const bool elastic : {false, true}) {
    CAPTURE(elastic);
    Simulation simulation = simulationOf(test::fullBlock({20, 10, 10}, 0.005), elastic);
    test::cutAlong(simulation, {Vec3::UnitX(), 0.01 + 7.4 * 0.005});
    OrganLedger ledger = ledgerOf(simulation).organs[0];
    REQUIRE(ledger.parts.size() == 2);
    CHECK(ledger.parts[0].tissue.particles == 1200);
    CHECK(ledger.parts[1].tissue.particles == 800);
    CHECK(apart(ledger.tissue.pieces.mass, 800 * 1.25e-7 * 1060) < 1e-9);
    CHECK(apart(ledger.cut, 0.05 * 0.05) < 0.03);

    // Off the smaller piece: a crumb of 2 particles, 0.25 ml.
    const Lattice& lattice = simulation.organ().rest.lattice;
    FrameInput input;
    for (int z = 0; z < 10; ++z)
      for (int y = 0; y < 10; ++y)
        if (y > 0 || z > 1) input.edits.push_back({0, -1, RemoveCell{lattice.index({1, y, z})}});
    for (int z = 0; z < 10; ++z)
      for (int y = 0; y < 10; ++y)
        for (int x = 0; x < 2; ++x)
          if (!(x == 0 && y > 4 && z > 4) && !(x == 0 && y == 0 && z < 2))
            input.edits.push_back({0, -1, RemoveCell{lattice.index({x, y, z})}});
    simulation.step(input);
    ledger = ledgerOf(simulation).organs[0];
    REQUIRE(ledger.parts.size() == 3);
    CHECK(ledger.parts[1].tissue.particles == 600);
    CHECK(ledger.parts[2].tissue.particles == 25);
    CHECK(ledger.debrisParts == 1);
    CHECK(ledger.tissue.debris.particles == 2);
    CHECK(ledger.tissue.removed.particles == 200 - 27);
  }
}

TEST_CASE("parts of still tissue are those that its bonds give one by one") {
  Random random(11);
  for (int i = 0; i < 6; ++i) {
    Simulation simulation =
        simulationOf(i % 2 ? test::blob(22) : test::noise({16, 14, 15}, 7 + i), false);
    const Lattice& lattice = simulation.organ().rest.lattice;
    for (int k = 0; k < 3; ++k) {
      const Vec3 normal = test::randomDirection(random);
      test::cutAlong(simulation,
                     {normal, normal.dot(lattice.box().centre()) + random.uniform(-0.03, 0.03)});
      FrameInput input;
      for (int r = 0; r < 200; ++r)
        input.edits.push_back({0, -1, RemoveCell{random.below(int(lattice.cellCount()))}});
      simulation.step(input);
    }
    // Flooded cell by cell.
    std::vector<std::int64_t> sizes, stack;
    std::vector<char> seen(std::size_t(lattice.cellCount()), 0);
    std::vector<double> volumes;
    for (std::int64_t first = 0; first < lattice.cellCount(); ++first) {
      if (seen[std::size_t(first)] || !simulation.tissue().solid(first)) continue;
      volumes.push_back(0);
      seen[std::size_t(first)] = 1;
      stack.push_back(first);
      while (!stack.empty()) {
        const std::int64_t cell = stack.back();
        stack.pop_back();
        volumes.back() += particleVolume(simulation.organ().rest, cell);
        const std::uint32_t bonds = simulation.tissue().bonds(cell);
        for (int d = 0; d < kDirections; ++d) {
          if (!(bonds >> d & 1)) continue;
          const std::int64_t other = lattice.index(lattice.cell(cell) + offsetOf(d));
          if (seen[std::size_t(other)]) continue;
          seen[std::size_t(other)] = 1;
          stack.push_back(other);
        }
      }
    }
    std::ranges::sort(volumes, std::greater());
    const OrganLedger ledger = ledgerOf(simulation).organs[0];
    CHECK(std::int64_t(ledger.parts.size()) + ledger.debrisParts == std::int64_t(volumes.size()));
    for (std::size_t p = 0; p < ledger.parts.size(); ++p)
      CHECK(apart(ledger.parts[p].tissue.volume, volumes[p]) < 1e-6);
  }
}

TEST_CASE(
    "the watch gives a ledger once a second at most, when something has changed, and at the end") {
  Simulation simulation = simulationOf(test::fullBlock({10, 10, 10}, 0.005), false);
  Scenario scenario;
  LedgerWatch watch(scenario, simulation);
  CHECK(watch.anew(simulation).organs[0].tissue.removed.particles == 0);
  int given = 0;
  for (int i = 0; i < 150; ++i) {
    FrameInput input;
    if (i < 70) input.edits.push_back({0, -1, RemoveCell{i}});
    const StepReport report = simulation.step(input);
    if (const Ledger* ledger = watch.after(report, simulation)) {
      ++given;
      CHECK(ledger->organs[0].tissue.removed.particles == simulation.organ().removed);
      CHECK(simulation.time() == doctest::Approx(given));
    }
  }
  CHECK(given == 2);
  CHECK(watch.last(simulation) == nullptr);
  FrameInput input;
  input.edits.push_back({0, -1, RemoveCell{500}});
  CHECK(watch.after(simulation.step(input), simulation) == nullptr);
  REQUIRE(watch.last(simulation) != nullptr);
  CHECK(watch.ledger().organs[0].tissue.removed.particles == 71);
}

TEST_CASE(
    "books that do not fit an operation are refused, and a ledger that does not close is found") {
  Simulation simulation = simulationOf(test::fullBlock({4, 4, 4}, 0.005), false);
  CHECK(test::isOneSentence(
      test::sentenceOf([&] { LedgerBooks(std::vector<TissueSetup>(2), simulation); })));
  Ledger ledger = ledgerOf(simulation);
  ledger.organs[0].tissue.body.mass *= 1 + 1e-9;
  CHECK(discrepancy(ledger).find(" g of ") != std::string::npos);
  ledger = ledgerOf(simulation);
  ++ledger.organs[0].labels[0].tissue.removed.particles;
  CHECK(discrepancy(ledger).find("65 particles of 64") != std::string::npos);
  ledger = ledgerOf(simulation);
  ledger.organs[0].parts.clear();
  CHECK(discrepancy(ledger) != "");
}
