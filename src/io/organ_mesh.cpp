#include "io/organ_mesh.h"

#include <algorithm>
#include <utility>

#include "base/error.h"
#include "base/text/shown_text.h"
#include "geometry/measures.h"
#include "geometry/repair/crossings.h"
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
  if (model.parts.size() > 1)
    return error(
        "{}: its {} {}parts together are no closed body ({} boundary edges, the first at {}; "
        "{} edges of more than two triangles); choose {} with --part, which may be given several "
        "times: {}",
        model.path, model.parts.size(), options.part.empty() ? "" : "chosen ", health.boundaryEdges,
        where, health.nonManifoldEdges, options.part.empty() ? "some" : "others", partList(model));
  return error(
      "{}: the surface is open, it has {} boundary edge{}, the first at {}; close it, or "
      "let --repair do it",
      model.path, health.boundaryEdges, health.boundaryEdges == 1 ? "" : "s", where);
}

const char* plural(int count) { return count == 1 ? "" : "s"; }

// Name of the part that fills the box of the shell; "" if none does.
std::string partOf(const Shell& shell, const Model& model, double metresPerUnit) {
  const double close = 1e-5 * shell.box.size().norm();
  for (const ModelPart& part : model.parts) {
    Aabb box = bounds(part.mesh);
    box.min *= metresPerUnit;
    box.max *= metresPerUnit;
    if (model.parts.size() > 1 && (box.min - shell.box.min).norm() < close &&
        (box.max - shell.box.max).norm() < close)
      return part.name;
  }
  return "";
}

// What the shells of an organ mean, which a person may have meant otherwise.
void addShellNotes(const Model& model, const OrganMeshOptions& options, OrganMesh& organ) {
  const std::vector<std::string> known = partNames(options.structures);
  const auto nameOf = [&](const Shell& shell) {
    const std::string part = partOf(shell, model, options.metresPerUnit);
    return part.empty() ? "the one round " + place(shell.box.centre())
                        : fmt::format("part '{}'", shownText(part, kLongestName));
  };
  const auto tell = [&](ShellKind kind, const char* what, const char* meaning) {
    double all = 0;
    int count = 0;
    const Shell* largest = nullptr;
    for (const Shell& shell : organ.shells) {
      if (shell.kind != kind ||
          (!known.empty() &&
           std::ranges::count(known, partOf(shell, model, options.metresPerUnit)) > 0))
        continue;
      ++count, all += shell.volume;
      if (!largest || shell.volume > largest->volume) largest = &shell;
    }
    if (count == 0) return;
    organ.notes.push_back(fmt::format("{} inner shell{} of {:.4g} ml{} {} ({}{}){}", count,
                                      plural(count), all * 1e6, count > 1 ? " in all" : "", what,
                                      count > 1 ? "the largest is " : "", nameOf(*largest),
                                      meaning));
  };
  tell(ShellKind::Cavity, "facing inwards: a cavity without tissue", "");
  const bool named = model.parts.size() > 1 && !model.parts[0].name.empty();
  tell(ShellKind::Within, "facing outwards",
       named ? ": what it encloses is tissue; give a part that is a cavity or a tumour this role "
               "(--structure cavity=PART)"
             : ": what it encloses is tissue; if it is a cavity, turn its faces inwards in the "
               "program that made it");
}

// Leaves out the shells that have tissue on both sides, or on neither: they bound nothing, and the
// lattice's surface would be fitted to them. Shells that reach through others stay.
void leaveOutWithin(OrganMesh& organ) {
  if (std::ranges::count(organ.shells, ShellKind::Within, &Shell::kind) == 0) return;
  const std::vector<TriangleMesh> bodies = splitComponents(organ.mesh);
  TriangleMesh bounding;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (organ.shells[i].kind != ShellKind::Within) append(bounding, bodies[i]);
  TriangleMesh kept = bounding;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (organ.shells[i].kind != ShellKind::Within) continue;
    const std::vector<int> rounds = crossingNumbers(bounding, bodies[i].points);
    if (std::ranges::count(rounds, rounds[0]) != std::ptrdiff_t(rounds.size()))
      append(kept, bodies[i]);
  }
  organ.mesh = std::move(kept);
  organ.health = examine(organ.mesh);
}

// Components that reach into others, of which the shells say nothing. With very many components,
// such as those of a tree of vessels, it would take too long.
void addOverlapNote(OrganMesh& organ) {
  constexpr int kMost = 32;
  if (organ.health.components < 2 || organ.health.components > kMost) return;
  const std::vector<TriangleMesh> bodies = splitComponents(organ.mesh);
  int through = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    TriangleMesh others;
    for (std::size_t k = 0; k < bodies.size(); ++k)
      if (k != i) append(others, bodies[k]);
    const std::vector<int> rounds = crossingNumbers(others, bodies[i].points);
    const auto [low, high] = std::ranges::minmax(rounds);
    // Single points can lie on the other's surface.
    const auto few = std::ptrdiff_t(rounds.size() / 50);
    through += std::ranges::count(rounds, low) > few && std::ranges::count(rounds, high) > few &&
               low != high;
  }
  if (through > 0)
    organ.notes.push_back(fmt::format(
        "{} component{} into others; what they share counts twice in the volume that is "
        "told here, and once in the organ",
        through, through == 1 ? " reaches" : "s reach"));
}

void addNotes(const OrganMeshOptions& options, OrganMesh& organ) {
  const RepairReport& r = organ.repairs;
  const auto note = [&]<typename... Args>(fmt::format_string<Args...> format, Args&&... args) {
    organ.notes.push_back(fmt::format(format, std::forward<Args>(args)...));
  };
  if (r.trianglesDoubled > 0)
    note("{} triangles dropped that lie on others: every face was there more than once",
         r.trianglesDoubled);
  if (r.trianglesTurned > 0)
    note("{} triangle{} turned so that neighbours agree", r.trianglesTurned,
         plural(r.trianglesTurned));
  if (r.holesClosed > 0) {
    const double change = r.volumeAfter - r.volumeBefore;
    note(
        "{} hole{} closed with {} triangle{} ({:.3g} mm^2), which changed the volume by {:+.4g} ml "
        "({:+.3g} %)",
        r.holesClosed, plural(r.holesClosed), r.trianglesAdded, plural(r.trianglesAdded),
        r.areaAdded * 1e6, change * 1e6, r.volumeBefore != 0 ? 100 * change / r.volumeBefore : 0.0);
  }
  if (r.specksDropped > 0)
    note("{} speck{} without volume dropped", r.specksDropped, plural(r.specksDropped));
  if (r.componentsTurned > 0)
    note("{} component{} inside out turned", r.componentsTurned, plural(r.componentsTurned));
  if (organ.health.components > 1) note("the surface has {} components", organ.health.components);
  const std::string doubt = sizeDoubt(organ.health.bounds, options.metresPerUnit);
  if (!doubt.empty()) organ.notes.push_back(doubt);
}

// Repairs organ.mesh, whose health is organ.health, to a closed, oriented surface, or throws Error.
void mend(const Model& model, const OrganMeshOptions& options, OrganMesh& organ) {
  const MeshHealth& raw = organ.health;
  const bool severalParts = model.parts.size() > 1;
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
  TriangleMesh mesh = part.empty() ? merged(model) : merged(chosenParts(model, part));
  if (metresPerUnit != 1)
    for (Vec3& p : mesh.points) p *= metresPerUnit;
  return mesh;
}

OrganMesh prepareOrganMesh(const Model& all, const OrganMeshOptions& options) {
  const Model chosen = options.part.empty() ? Model() : chosenParts(all, options.part);
  const Model& model = options.part.empty() ? all : chosen;
  if (model.format == "3MF" && options.metresPerUnit != 1)
    throw usageError("{}: a .3mf tells its unit itself; leave the unit out", model.path);
  OrganMesh organ;
  WeldedSurface welded = weldSurface(chosenSurface(model, "", options.metresPerUnit));
  organ.mesh = std::move(welded.mesh);
  if (organ.mesh.triangles.empty())
    throw error("{}: all its triangles are degenerate; export the model again", model.path);
  organ.health = examine(organ.mesh, welded.topology);
  const MeshHealth& h = organ.health;
  const std::string doubt = sizeDoubt(h.bounds, options.metresPerUnit);
  try {
    if (h.nonManifoldEdges > 0) {
      dropDoubled(organ.mesh, organ.repairs);
      if (organ.repairs.trianglesDoubled > 0) organ.health = examine(organ.mesh);
    }
    if (!h.closed || !h.oriented || h.specks > 0 || h.insideOut) {
      mend(model, options, organ);
      organ.health = examine(organ.mesh);
    }
  } catch (const Error& e) {
    throw withDoubt(e, doubt);
  }
  if (organ.health.components > 1) {
    organ.shells = shellsOf(organ.mesh);
    leaveOutWithin(organ);
  }
  organ.volume = organ.shells.empty() ? volumeAbout(organ.mesh, organ.health.bounds.centre())
                                      : tissueVolume(organ.shells);
  addNotes(options, organ);
  addShellNotes(model, options, organ);
  addOverlapNote(organ);
  return organ;
}

}  // namespace resect
