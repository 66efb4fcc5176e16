#include "io/organ_mesh.h"

#include <utility>

#include "base/error.h"
#include "geometry/repair/weld.h"
#include "geometry/topology.h"
#include "io/organ_size.h"

namespace resect {
namespace {

std::string place(const Vec3& p) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g}) m", p.x(), p.y(), p.z());
}

Error openSurface(const Model& model, const OrganMeshOptions& options, const MeshHealth& health) {
  const std::string where = health.firstBoundaryPoint ? place(*health.firstBoundaryPoint) : "";
  if (model.parts.size() > 1 && options.part.empty())
    return error(
        "{}: its {} parts together are no closed body ({} boundary edges, the first at {}; "
        "{} edges of more than two triangles); choose one with --part: {}",
        model.path, model.parts.size(), health.boundaryEdges, where, health.nonManifoldEdges,
        partList(model));
  return error(
      "{}: the surface is open, it has {} boundary edge{}, the first at {}; close it, or "
      "let --repair do it",
      model.path, health.boundaryEdges, health.boundaryEdges == 1 ? "" : "s", where);
}

const char* plural(int count) { return count == 1 ? "" : "s"; }

void addNotes(const OrganMeshOptions& options, OrganMesh& organ) {
  const RepairReport& r = organ.repairs;
  const auto note = [&]<typename... Args>(fmt::format_string<Args...> format, Args&&... args) {
    organ.notes.push_back(fmt::format(format, std::forward<Args>(args)...));
  };
  if (r.trianglesTurned > 0)
    note("{} triangle{} turned so that neighbours agree", r.trianglesTurned,
         plural(r.trianglesTurned));
  if (r.holesClosed > 0) {
    const double change = r.volumeAfter - r.volumeBefore;
    note(
        "{} hole{} closed with {} triangle{} ({:.3g} mm^2), which changed the volume by {:+.4g} ml "
        "({:+.3g} %)",
        r.holesClosed, plural(r.holesClosed), r.trianglesAdded, plural(r.trianglesAdded),
        r.areaAdded * 1e6, change * 1e6, r.volumeAfter != 0 ? 100 * change / r.volumeAfter : 0.0);
  }
  if (r.specksDropped > 0)
    note("{} speck{} without volume dropped", r.specksDropped, plural(r.specksDropped));
  if (r.componentsTurned > 0)
    note("{} component{} inside out turned", r.componentsTurned, plural(r.componentsTurned));
  if (organ.health.components > 1) note("the surface has {} components", organ.health.components);
  if (!isOrganSized(organ.health.bounds)) {
    // The hint refers to the file's own numbers.
    Aabb own = organ.health.bounds;
    own.min /= options.metresPerUnit;
    own.max /= options.metresPerUnit;
    note("its longest side is {:.4g} m, which is no organ's; perhaps the file is in {} (--unit)",
         organ.health.bounds.size().maxCoeff(), plausibleUnit(own));
  }
}

// Repairs organ.mesh, whose health is organ.health, to a closed, oriented surface, or throws Error.
void mend(const Model& model, const OrganMeshOptions& options, OrganMesh& organ) {
  const MeshHealth& raw = organ.health;
  const bool severalParts = model.parts.size() > 1 && options.part.empty();
  // Parts that overlap have edges of more than two triangles: closing the holes between them would
  // give a meaningless closed surface.
  if (!raw.closed && (!options.repair || (severalParts && raw.nonManifoldEdges > 0)))
    throw openSurface(model, options, raw);
  if (!raw.closed || !raw.oriented) {
    orientConsistently(organ.mesh, organ.repairs);
    if (options.repair) closeHoles(organ.mesh, organ.repairs);
    if (!topology(organ.mesh).oriented())
      throw error(
          "{}: its triangles cannot agree on an outside (it is one-sided, or parts share "
          "edges); separate the parts, or let --repair do it",
          model.path);
  }
  dropSpecks(organ.mesh, organ.repairs);
  if (organ.mesh.triangles.empty())
    throw error("{}: its surface encloses no volume; choose a file that holds a body", model.path);
  turnOutwards(organ.mesh, organ.repairs);
}

}  // namespace

WeldedSurface weldSurface(const TriangleMesh& mesh) {
  WeldedSurface exact{weld(mesh), {}};
  exact.topology = topology(exact.mesh);
  if (exact.topology.closed()) return exact;
  constexpr double kRounding = 1e-6;
  WeldedSurface near{weld(mesh, kRounding), {}};
  near.topology = topology(near.mesh);
  return near.topology.closed() && !near.mesh.triangles.empty() ? near : exact;
}

TriangleMesh chosenSurface(const Model& model, const std::string& part, double metresPerUnit) {
  TriangleMesh mesh = part.empty() ? merged(model) : partNamed(model, part).mesh;
  if (metresPerUnit != 1)
    for (Vec3& p : mesh.points) p *= metresPerUnit;
  return mesh;
}

OrganMesh prepareOrganMesh(const Model& model, const OrganMeshOptions& options) {
  OrganMesh organ;
  WeldedSurface welded = weldSurface(chosenSurface(model, options.part, options.metresPerUnit));
  organ.mesh = std::move(welded.mesh);
  if (organ.mesh.triangles.empty())
    throw error("{}: all its triangles are degenerate; export the model again", model.path);
  organ.health = examine(organ.mesh, welded.topology);
  const MeshHealth& h = organ.health;
  if (!h.closed || !h.oriented || h.specks > 0 || h.insideOut) {
    mend(model, options, organ);
    organ.health = examine(organ.mesh);
  }
  addNotes(options, organ);
  return organ;
}

}  // namespace resect
