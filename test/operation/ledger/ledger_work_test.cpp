// The ledger under long random work: at each update it closes.
//
// Livers, gallbladders, balls and boxes, turned and shifted, still and elastic, are cut, hooked,
// torn and eaten away at random. RESECT_LEDGER_SECONDS: how long in all, in simulated seconds (16);
// RESECT_LEDGER_SEED.
#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <cstdlib>
#include <numbers>

#include "geometry/primitives.h"
#include "operation/ledger/ledger_watch.h"
#include "organ/builtin/builtin_gallbladder.h"
#include "organ/builtin/builtin_liver.h"
#include "organ/cell_labels.h"
#include "organ/discretize.h"
#include "support/blades.h"
#include "support/environment.h"
#include "support/test_tools.h"
#include "tissue/elastic/elastic_tissue.h"

using namespace resect;

namespace {

std::vector<std::unique_ptr<Tool>> instruments() {
  std::vector<std::unique_ptr<Tool>> tools;
  const auto add = [&](const char* kind, TriangleMesh mesh, auto describe) {
    tools.push_back(test::describedTool(kind, std::move(mesh), describe));
  };
  add("scalpel", boxMesh({{-0.0003, -0.008, 0}, {0.0003, 0.003, 0.15}}), [](ToolModel& m) {
    m.edge = {{0, -0.008, -0.08}, {0, -0.0082, 0}, {0, -0.008, 0.08}};
  });
  add("hook", boxMesh({{-0.0015, -0.0015, 0}, {0.0015, 0.0015, 0.15}}), [](ToolModel& m) {
    m.hook = {{0, -0.01, 0.01}, {0, 0, 0}, {0, 0.01, 0.01}};
    m.slipForce = 1e3;  // the tissue tears first
  });
  tools.push_back(test::ballTool(0.006));
  tools.push_back(test::boxTool({{-0.004, -0.001, 0}, {0.004, 0.001, 0.05}}));
  return tools;
}

// One organ that stands somewhere, of some 600 to 2500 particles, with a named ball in it.
Simulation randomOrgan(int kind, bool elastic, Random& random) {
  TriangleMesh mesh = kind == 0   ? builtinGallbladder(0.0025)
                      : kind == 1 ? sphereMesh({0, 0, 0}, 0.03)
                      : kind == 2 ? boxMesh({{-0.04, -0.015, -0.03}, {0.04, 0.015, 0.03}})
                                  : builtinLiver(0.005);
  const double spacing = kind == 3 ? 0.01 : 0.004;
  const Eigen::Quaterniond turn(
      Eigen::AngleAxisd(random.uniform(0, std::numbers::pi), test::randomDirection(random)));
  for (Vec3& p : mesh.points) p = turn * p;
  const Vec3 move = Vec3(0.01, -bounds(mesh).min.y() + 0.0017, -0.02) +
                    0.003 * Vec3(random.uniform(), random.uniform(), random.uniform());
  for (Vec3& p : mesh.points) p += move;
  Discretization cells = discretize(mesh, latticeForSpacing(bounds(mesh), spacing));
  Region ball;
  ball.shape = Region::Shape::Ball;
  ball.centre = cells.lattice.box().centre();
  ball.radius = 4 * spacing;
  markCells(cells, 2, ball);
  labelSkin(cells);
  cells.nameLabel(2, "tumour");
  std::unique_ptr<TissueModel> tissue;
  if (elastic)
    tissue = std::make_unique<ElasticTissue>(
        TissueCells{cells.lattice, cells.inside, {TissueMaterial{}}, {}}, TissueSettings{});
  return Simulation(makeOrgan(std::move(cells), {}), instruments(), std::move(tissue));
}

struct Tally {
  std::int64_t ledgers = 0, severed = 0, torn = 0, removed = 0, pieces = 0, debris = 0, acts = 0;
  double cut = 0;  // m^2
};

// Works on one organ for some seconds, with one instrument after another along straight lines.
void work(Simulation& simulation, double seconds, Random& random, Tally& tally) {
  Scenario scenario;
  scenario.organs[0].tissue.materials = {{2, TissueMaterial{}}};
  scenario.organs[0].tissue.materials[0].material.density = 1500;
  LedgerWatch watch(scenario, simulation);
  Aabb box = simulation.organ().rest.lattice.box();
  const auto inside = [&] {
    return Vec3(random.uniform(box.min.x(), box.max.x()), random.uniform(box.min.y(), box.max.y()),
                random.uniform(box.min.z(), box.max.z()));
  };
  const auto check = [&](const Ledger& ledger) {
    ++tally.ledgers;
    REQUIRE(discrepancy(ledger, &simulation) == "");
    const OrganLedger& organ = ledger.organs[0];
    REQUIRE(organ.cut >= 0);
    REQUIRE(organ.parts.size() + std::size_t(organ.tissue.left().volume == 0) > 0);
    for (std::size_t p = 1; p < organ.parts.size(); ++p) {
      REQUIRE(organ.parts[p].tissue.volume > 0);
      REQUIRE(organ.parts[p].tissue.volume <= organ.parts[p - 1].tissue.volume);
    }
    REQUIRE(organ.labels.size() == 2);
    REQUIRE(*organ.labels[1].margin >= 0);
  };
  check(watch.anew(simulation));
  std::size_t tool = 0;
  Pose at;
  Vec3 end = Vec3::Zero();
  double speed = 0;
  const auto frames = std::int64_t(60 * seconds);
  for (std::int64_t frame = 0; frame < frames; ++frame) {
    const Vec3 left = end - at.position;
    if (frame % 40 == 0 || left.norm() < 1e-6) {
      ++tally.acts;
      tool = std::size_t(random.below(int(simulation.tools().size())));
      at.rotation =
          Eigen::AngleAxisd(random.uniform(0, 2 * std::numbers::pi), test::randomDirection(random));
      const Vec3 through = inside();
      const Vec3 way = 0.8 * box.size().norm() * test::randomDirection(random);
      at.position = tool == 1 ? through : Vec3(through - way);  // a hook begins in the tissue
      end = through + way;
      if (tool == 1) end = through + way.norm() * (at.rotation * Vec3::UnitZ());  // it pulls
      speed = random.uniform(0.1, 0.6);
    } else {
      at.position += left.normalized() * std::min(left.norm(), speed / 60);
    }
    FrameInput input;
    for (std::size_t t = 0; t < simulation.tools().size(); ++t)
      input.tools.push_back({at, t == tool && frame > 10});
    const StepReport report = simulation.step(input);
    tally.severed += report.severed, tally.torn += report.torn, tally.removed += report.removed;
    if (const Ledger* ledger = watch.after(report, simulation)) check(*ledger);
    if (simulation.organ().particles < 100) break;  // little is left to work on
  }
  if (const Ledger* ledger = watch.last(simulation)) check(*ledger);
  const OrganLedger& organ = watch.ledger().organs[0];
  tally.pieces += std::int64_t(organ.parts.size()) - 1;
  tally.debris += organ.debrisParts;
  tally.cut += organ.cut;
}

}  // namespace

TEST_CASE("random work: whatever is cut, torn and removed, the ledger closes at each update") {
  const double seconds = test::numberFrom("RESECT_LEDGER_SECONDS", 16);
  Random random(std::uint64_t(test::numberFrom("RESECT_LEDGER_SEED", 4)));
  Tally tally;
  double done = 0;
  for (int i = 0; done < seconds; ++i) {
    Simulation simulation = randomOrgan(i % 4, i / 4 % 2 == i % 2, random);
    work(simulation, std::max(2.0, std::min(10.0, seconds / 8)), random, tally);
    done += simulation.time();
  }
  MESSAGE(tally.ledgers << " ledgers in " << done << " s: " << tally.acts << " acts, "
                        << tally.severed << " bonds cut, " << tally.torn << " torn, "
                        << tally.removed << " particles removed, " << tally.pieces << " pieces and "
                        << tally.debris << " parts of debris at the ends, " << 1e4 * tally.cut
                        << " cm2 of cuts");
  CHECK(tally.ledgers > 8);
  CHECK(tally.severed > 100);
  CHECK(tally.removed > 100);
  CHECK(tally.torn > 0);
  CHECK(tally.pieces + tally.debris > 0);
}
