#include "io/surroundings/surroundings_of.h"

#include <fmt/format.h>

#include <algorithm>

#include "collision/inside.h"
#include "io/data_folder.h"
#include "io/plain_mesh.h"
#include "operation/room.h"

namespace resect {
namespace {

// Side of the cells of the wall's grid of distances where the field is not scaled, m. With these
// the grid takes 0.06 s to make and follows the mesh within 0.3 mm on average.
constexpr double kWallCell = 0.007;

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
  StandingBody wall = abdominalWall(fieldPlace(box));
  const std::int64_t in = particlesIn(wall, organs);
  if (in == 0) return {{std::move(wall)}, {}};
  if (notes)
    notes->push_back(fmt::format(
        "the abdominal wall of the operative field stops no tissue, since {} particle{} in it at "
        "the start",
        in, in == 1 ? " lies" : "s lie"));
  return {};
}

StandingBody abdominalWall(const FieldPlace& place) {
  TriangleMesh shape = merged(readPlainMesh(dataFolder() / "room" / "field_wall.ply"));
  for (Vec3& point : shape.points) point *= place.scale;
  return {"abdominal wall",
          std::move(shape),
          {place.position, Eigen::Quaterniond::Identity()},
          kWallCell * place.scale};
}

}  // namespace resect
