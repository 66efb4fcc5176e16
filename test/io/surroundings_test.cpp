// What stands round the organs stops tissue: the operative field's body, the tray, the table.
#include <doctest/doctest.h>

#include <algorithm>

#include "base/parallel.h"
#include "geometry/measures.h"
#include "geometry/primitives.h"
#include "geometry/repair/mesh_health.h"
#include "io/operation_setup.h"
#include "io/plain_mesh.h"
#include "io/scenario/scenario_file.h"
#include "io/surroundings/surroundings_of.h"
#include "organ/discretize.h"
#include "support/block_organ.h"
#include "support/same_at_any_threads.h"
#include "support/sentence.h"
#include "tissue/elastic/elastic_tissue.h"

using namespace resect;

namespace {

constexpr double kSpacing = 0.006;  // m, of the blocks

// A soft block of 5 x 4 x 5 cells with the middle of its underside at `place`.
Simulation block(const Vec3& place, const Vec3& gravity = {0, -9.81, 0}) {
  Discretization cells = test::fullBlock({5, 4, 5}, kSpacing);
  cells.lattice.origin = place + Vec3(-2 * kSpacing, 0.5 * kSpacing, -2 * kSpacing);
  TissueSettings settings;
  settings.drag = 6;
  settings.gravity = gravity;
  TissueMaterial material;
  material.young = 20000;
  auto tissue = std::make_unique<ElasticTissue>(
      TissueCells{cells.lattice, cells.inside, {material}, {}}, settings);
  return Simulation(makeOrgan(std::move(cells), {}), {}, std::move(tissue));
}

void run(Simulation& simulation, double seconds) {
  FrameInput input;
  for (double t = 0; t < seconds; t += input.duration) simulation.step(input);
}

std::vector<Vec3> particles(const Simulation& simulation) {
  const OperatedOrgan& o = simulation.organs()[0];
  const Lattice& lattice = o.organ.rest.lattice;
  std::vector<Vec3> places;
  for (std::int64_t c = 0; c < lattice.cellCount(); ++c)
    if (o.organ.alive[std::size_t(c)])
      places.push_back(lattice.centre(lattice.cell(c)) + o.tissue->displacement(c));
  return places;
}

Vec3 middle(const Simulation& simulation) {
  Vec3 sum = Vec3::Zero();
  const std::vector<Vec3> all = particles(simulation);
  for (const Vec3& place : all) sum += place;
  return sum / double(all.size());
}

// Height of the highest point of a body within `reach` of a place, m.
double heightAt(const StandingBody& body, double x, double z, double reach) {
  double highest = -1;
  for (const Vec3& point : body.shape.points) {
    const Vec3 p = body.pose * point;
    if (std::hypot(p.x() - x, p.z() - z) < reach) highest = std::max(highest, p.y());
  }
  return highest;
}

std::string namesOf(const Surroundings& surroundings) {
  std::string names;
  for (const StandingBody& body : surroundings.bodies)
    names += (names.empty() ? "" : ", ") + body.name;
  return names;
}

// Places over the wall, where the field is not scaled: x and z, m.
constexpr double kOver[][2] = {{-0.215, 0.0}, {0.2, 0.03}, {0.0, -0.19}};

Scenario liverIn(const std::string& setting) {
  Scenario scenario;
  scenario.mode = OperationMode::Operation;
  scenario.organs[0].source.spacing = 0.012;
  scenario.organs[0].tissue.elastic = true;
  scenario.setting = setting;
  return scenario;
}

}  // namespace

TEST_CASE("the abdominal wall is closed and turned outwards") {
  const MeshHealth health = examine(abdominalWall({}).shape);
  CHECK(health.closed);
  CHECK(health.oriented);
  CHECK_FALSE(health.insideOut);
}

TEST_CASE("a block that falls on the abdominal wall comes to rest on it") {
  for (const FieldPlace& place : {FieldPlace{Vec3::Zero(), 1}, FieldPlace{{0.3, 0, -0.2}, 0.6},
                                  FieldPlace{{-0.1, 0, 0.05}, 1.6}}) {
    const StandingBody body = abdominalWall(place);
    for (const auto& [x, z] : kOver) {
      CAPTURE(x);
      CAPTURE(place.scale);
      const Vec3 at = place.position + place.scale * Vec3(x, 0, z);
      const double top = heightAt(body, at.x(), at.z(), 0.012 * std::max(1.0, place.scale));
      CHECK(top > 0.01);
      Simulation simulation = block({at.x(), top + 0.03, at.z()});
      simulation.surround({{body}, std::nullopt});
      const SignedDistance distance(body.shape, 0.02, 0.004 * place.scale, 0.03);
      double deepest = 1;
      for (int frame = 0; frame < 60; ++frame) {
        run(simulation, 0.01);
        for (const Vec3& p : particles(simulation))
          deepest = std::min(deepest, distance(body.pose.inverse() * p).distance);
      }
      // Centres of cells are kept out of it, but for what its coarse grid rounds off.
      CHECK(deepest > -0.0025 * place.scale);
      CHECK(deepest < 0.5 * kSpacing);  // it has come to it
    }
  }
}

TEST_CASE("a block that is pulled against the abdominal wall stays outside") {
  const StandingBody body = abdominalWall({});
  struct Pull {
    Vec3 from, gravity;
  };
  for (const Pull& pull :
       {Pull{{-0.09, 0.04, 0.02}, {-9, -2, 0}}, Pull{{0, 0.05, -0.08}, {0, -2, -9}}}) {
    CAPTURE(pull.from.transpose());
    Simulation simulation = block(pull.from, pull.gravity);
    simulation.surround({{body}, std::nullopt});
    const SignedDistance distance(body.shape, 0.02, 0.004, 0.03);
    double deepest = 1;
    for (int frame = 0; frame < 80; ++frame) {
      run(simulation, 0.01);
      for (const Vec3& p : particles(simulation)) deepest = std::min(deepest, distance(p).distance);
    }
    CHECK(deepest > -0.0025);
    CHECK(deepest < 0.006);
  }
}

TEST_CASE("the setting decides what stops tissue") {
  Scenario table = liverIn("table"), field = liverIn("field");
  std::vector<std::string> notes;
  const Simulation onTable = makeSimulation(table, readPlainMesh),
                   inField = makeSimulation(field, readPlainMesh, {}, &notes);
  CHECK(namesOf(onTable.surroundings()) == "tool box");
  CHECK(onTable.surroundings().edge.has_value());
  CHECK(namesOf(inField.surroundings()) == "abdominal wall");
  CHECK_FALSE(inField.surroundings().edge.has_value());
  CHECK(notes.empty());
  field.mode = OperationMode::Thesis;
  CHECK(namesOf(makeSimulation(field, readPlainMesh).surroundings()) == "tool box");
  // Still tissue comes to nothing, so nothing is kept for it.
  field = liverIn("field");
  field.organs[0].tissue.elastic = false;
  CHECK(makeSimulation(field, readPlainMesh).surroundings().bodies.empty());
}

TEST_CASE("an abdominal wall in which particles lie is left out and told of") {
  Scenario scenario = liverIn("field");
  scenario.organs.push_back(scenario.organs[0]);
  scenario.organs[0].source.name = "liver";
  OrganSource& ball = scenario.organs[1].source;
  ball.name = "ball";
  ball.file = "ball.obj";
  ball.spacing = 0.008;
  ball.onTable = false;
  ball.pose.position = {-0.55, 0.05,
                        0.0};  // the field lies round both organs, and grows 1.6 times at most
  std::vector<std::string> notes;
  const auto reader = [](const std::filesystem::path& path, const std::string&) {
    return Model{path.string(), "OBJ", {{"", sphereMesh({0, 0, 0}, 0.016, 16)}}};
  };
  const Simulation simulation = makeSimulation(scenario, reader, {}, &notes);
  CHECK(namesOf(simulation.surroundings()).empty());
  CHECK(std::ranges::any_of(notes, [](const std::string& note) {
    return test::tells(note, "the abdominal wall of the operative field stops no tissue, since");
  }));
}

TEST_CASE("a block beyond the table's edge falls to the floor, and one on the table stays") {
  const TableEdge edge{kTableHalfWidth, kTableHalfDepth, kFloor};
  for (const auto& [x, z, height] :
       {std::tuple(0.40, 0.0, 0.0), std::tuple(0.0, 0.25, 0.0), std::tuple(0.50, 0.0, kFloor),
        std::tuple(0.0, -0.34, kFloor)}) {
    CAPTURE(x);
    CAPTURE(z);
    Simulation simulation = block({x, 0.01, z});
    simulation.surround({{}, edge});
    run(simulation, 1.5);
    CHECK(middle(simulation).y() > height + 0.005);
    CHECK(middle(simulation).y() < height + 0.02);
  }
  // Two thirds over the edge: it tips, slides off and comes to lie below, beside the table.
  Simulation simulation = block({kTableHalfWidth + 0.006, 0.001, 0});
  simulation.surround({{}, edge});
  run(simulation, 3);
  CHECK(middle(simulation).y() < -0.5);
  for (const Vec3& p : particles(simulation)) CHECK((p.x() > kTableHalfWidth || p.y() > 0));
}

TEST_CASE("with the body as an obstacle: the same bits at any number of threads") {
  test::checkSameAtAnyThreads([](int) {
    Simulation simulation = block({-0.215, 0.12, 0.0});
    simulation.surround({{abdominalWall({})}, std::nullopt});
    run(simulation, 0.5);
    return simulation.stateHash();
  });
}

TEST_CASE("with the body as an obstacle: an operation goes on from a saved state") {
  Simulation simulation = block({-0.215, 0.12, 0.0}), other = block({-0.215, 0.12, 0.0});
  for (Simulation* one : {&simulation, &other}) one->surround({{abdominalWall({})}, std::nullopt});
  run(simulation, 0.3);
  other.restore(simulation.save());
  run(simulation, 0.3);
  run(other, 0.3);
  CHECK(simulation.stateHash() == other.stateHash());
}

TEST_CASE("where the tray stands on the table, nothing is in the way in the field") {
  const auto restingHeight = [](const std::string& setting) {
    Scenario scenario = liverIn(setting);
    scenario.organs[0].source.onTable = false;
    Simulation simulation = block(toolBoxPose() * Vec3(0, 0.05, 0.104));
    Surroundings around = surroundingsOf(scenario, simulation.organs());
    // The field lies round the block then; here it is that of an organ in the middle.
    if (setting == "field") around.bodies = {abdominalWall({{0.6, 0, 0}, 0.6})};
    simulation.surround(std::move(around));
    run(simulation, 1);
    return middle(simulation).y();
  };
  CHECK(restingHeight("table") > 0.03);
  CHECK(restingHeight("field") < 0.02);
}
