#include "io/surroundings/surroundings_of.h"

#include <fmt/format.h>

#include <algorithm>

#include "collision/inside.h"
#include "io/data_folder.h"
#include "io/plain_mesh.h"
#include "operation/room.h"

namespace resect {
namespace {

// A part of the body. cell: side of the cells of its grid of distances where the field is not
// scaled, m: with these the grids take 0.08 s to make and follow the meshes within 0.3 mm on
// average.
struct FieldPart {
  const char *name, *file;
  double cell;
};
constexpr FieldPart kFieldParts[] = {{"abdominal wall", "field_wall.ply", 0.007},
                                     {"stomach", "field_stomach.ply", 0.005},
                                     {"colon", "field_colon.ply", 0.005}};

bool anyMoves(std::span<const OperatedOrgan> organs) {
  return std::ranges::any_of(organs, [](const OperatedOrgan& o) { return o.tissue->moves(); });
}

StandingBody tray() { return {"tool box", toolBoxWalls(), toolBoxPose()}; }

// Whether a particle lies in the box round the tray, or half a cell beside it.
bool liesInTray(std::span<const OperatedOrgan> organs) {
  const Aabb box = bounds(transformed(toolBoxWalls(), toolBoxPose()));
  for (const OperatedOrgan& o : organs) {
    const Lattice& lattice = o.organ.rest.lattice;
    const Aabb reach = box.padded(0.5 * lattice.spacing.x());
    for (std::int64_t c = 0; c < lattice.cellCount(); ++c)
      if (o.organ.alive[std::size_t(c)] && reach.contains(lattice.centre(lattice.cell(c))))
        return true;
  }
  return false;
}

// Number of particles in a closed body.
std::int64_t particlesIn(const StandingBody& body, std::span<const OperatedOrgan> organs) {
  const Aabb box = bounds(transformed(body.shape, body.pose));
  std::vector<Vec3> places;
  for (const OperatedOrgan& o : organs) {
    const Lattice& lattice = o.organ.rest.lattice;
    for (std::int64_t c = 0; c < lattice.cellCount(); ++c) {
      if (!o.organ.alive[std::size_t(c)]) continue;
      const Vec3 place = lattice.centre(lattice.cell(c));
      if (box.contains(place)) places.push_back(body.pose.inverse() * place);
    }
  }
  return std::ranges::count(insideFlags(body.shape, places), 1);
}

}  // namespace

Surroundings surroundingsBefore(const Scenario& scenario, std::span<const OperatedOrgan> organs) {
  Surroundings found;
  if (scenario.toolBox && anyMoves(organs) && !liesInTray(organs)) found.bodies.push_back(tray());
  return found;
}

Surroundings surroundingsOf(const Scenario& scenario, std::span<const OperatedOrgan> organs,
                            std::vector<std::string>* notes) {
  if (!anyMoves(organs)) return {};
  if (!showsField(scenario)) {
    Surroundings found = surroundingsBefore(scenario, organs);
    if (scenario.table) found.edge = TableEdge{kTableHalfWidth, kTableHalfDepth, kFloor};
    return found;
  }
  Aabb box;
  for (const OperatedOrgan& o : organs) box.grow(o.organ.rest.lattice.box());
  Surroundings found;
  for (StandingBody& body : fieldBodies(fieldPlace(box)))
    if (const std::int64_t in = particlesIn(body, organs); in == 0)
      found.bodies.push_back(std::move(body));
    else if (notes)
      notes->push_back(fmt::format(
          "the {} of the operative field stops no tissue, since {} particle{} in it at the start",
          body.name, in, in == 1 ? " lies" : "s lie"));
  return found;
}

std::vector<StandingBody> fieldBodies(const FieldPlace& place) {
  std::vector<StandingBody> bodies;
  for (const FieldPart& part : kFieldParts) {
    TriangleMesh shape = merged(readPlainMesh(dataFolder() / "room" / part.file));
    for (Vec3& point : shape.points) point *= place.scale;
    bodies.push_back({part.name,
                      std::move(shape),
                      {place.position, Eigen::Quaterniond::Identity()},
                      part.cell * place.scale});
  }
  return bodies;
}

}  // namespace resect
