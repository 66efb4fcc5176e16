#include "io/structures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>

#include "anatomy/growth/vessel_growth.h"
#include "anatomy/thinning/centre_lines.h"
#include "base/error.h"
#include "base/text/shown_text.h"
#include "collision/signed_distance.h"
#include "geometry/measures.h"
#include "geometry/repair/crossings.h"
#include "io/cells/particle_file.h"
#include "io/data_folder.h"
#include "io/organ_mesh.h"
#include "io/vessels_file.h"
#include "organ/cell_labels.h"
#include "organ/region_placer.h"

namespace resect {
namespace {

constexpr double kVesselCell = 0.4e-3;  // m: of the lattice in which centre lines are found

// The closed surface of a structure in the coordinates of its file, m. Open ends of vessels are
// closed.
TriangleMesh ownSurface(const BroughtStructure& one, const ModelReader& readModel) {
  const bool openEnds = vesselKind(one.kind).has_value();
  return prepareOrganMesh(readModel(one.file, one.part), {one.part, openEnds, one.unit}).mesh;
}

// The volume that two closed surfaces have in common, from samples at the centres of kSteps^3 boxes
// in b's bounding box, m^3.
double commonVolume(const TriangleMesh& a, const TriangleMesh& b) {
  constexpr int kSteps = 24;
  const Aabb box = bounds(b);
  const Vec3 step = box.size() / kSteps;
  std::vector<Vec3> points;
  for (int z = 0; z < kSteps; ++z)
    for (int y = 0; y < kSteps; ++y)
      for (int x = 0; x < kSteps; ++x)
        points.push_back(box.min + step.cwiseProduct(Vec3(x + 0.5, y + 0.5, z + 0.5)));
  const std::vector<int> inA = crossingNumbers(a, points), inB = crossingNumbers(b, points);
  int both = 0;
  for (std::size_t i = 0; i < points.size(); ++i) both += inA[i] > 0 && inB[i] > 0;
  return both * step.prod();
}

// The closed surface of a structure in the room.
TriangleMesh placedSurface(const BroughtStructure& one, const std::optional<Pose>& place,
                           const ModelReader& readModel) {
  if (!place)
    throw error(
        "{}: the organ is a file of particles, which tells no place for other files; leave this "
        "structure out, or take a model file for the organ",
        one.file);
  return transformed(ownSurface(one, readModel), *place);
}

// Labels the particles inside the surface; returns their number.
std::int64_t markInside(Discretization& cells, int label, const TriangleMesh& surface) {
  const double cell = cells.lattice.spacing.minCoeff();
  const SignedDistance distance(surface, cell, 0.5 * cell);
  cells.label.resize(std::size_t(cells.lattice.cellCount()), 0);
  std::int64_t marked = 0;
  visitCellsIn(cells.lattice, distance.box(), [&](const Vec3i& at) {
    const auto i = std::size_t(cells.lattice.index(at));
    if (!cells.inside[i] || distance(cells.lattice.centre(at)).distance > 0) return;
    cells.label[i] = std::uint8_t(label);
    ++marked;
  });
  return marked;
}

void requireMarked(std::int64_t particles, const Discretization& cells, const std::string& what,
                   const std::string& advice) {
  if (particles == 0)
    throw error("{} marks no particle of the organ; {} (the organ at rest fills {})", what, advice,
                boxText(particleBox(cells)));
}

// Appends a tree, whose parents count from its own first segment.
void append(std::vector<VesselSegment>& all, std::vector<VesselSegment> tree) {
  const auto offset = std::int32_t(all.size());
  for (VesselSegment& s : tree) {
    if (s.parent >= 0) s.parent += offset;
    all.push_back(s);
  }
}

// The vessels of the source's own files or of the built-in organ, in the room.
Anatomy ownVessels(const OrganSource& source, const std::optional<Pose>& place,
                   std::vector<std::string>* notes) {
  if (isCellsFile(source.file)) {
    KeptCells kept = readCells(source.file);
    const Pose shift{placedBy(source, kept.cells.lattice.box()), Eigen::Quaterniond::Identity()};
    if (!kept.vessels.empty()) return transformed(std::move(kept.vessels), shift);
  }
  if (source.vessels.empty()) return {};
  if (isVesselsFile(source)) {
    if (!place)
      throw error(
          "organ \"{}\" is a file of particles, which has no place for vessels; leave out vessels",
          source.name);
    return transformed(readVessels(source.vessels), *place);
  }
  if (hasVessels(source))
    return transformed(
        readVessels(dataFolder() / "organs" / fmt::format("{}.vessels", source.file)), *place);
  if (notes)
    notes->push_back("the vessels are those of another organ and were left out: it does not bleed");
  return {};
}

// With vessels down to half a millimetre in the whole organ, as dense as in the built-in liver.
Anatomy withSmallVessels(Anatomy brought, const TriangleMesh& surface,
                         std::vector<std::string>* notes) {
  constexpr double kPerVolume = 1000 / 1.6e-3;  // terminals, 1/m^3
  VesselGrowth growth;
  growth.terminals = std::clamp(int(kPerVolume * volume(surface)), 30, 1000);
  try {
    Anatomy grown = growVessels(surface, growth, brought.segments);
    if (notes)
      notes->push_back(fmt::format(
          "smaller vessels were grown from the {} segments that were found in the files of "
          "vessels: {} in all; small_vessels = false in [organ] leaves them out",
          brought.segments.size(), grown.segments.size()));
    return grown;
  } catch (const Error& e) {
    if (notes) notes->push_back(fmt::format("no smaller vessels were grown: {}", e.what()));
    return brought;
  }
}

}  // namespace

Vec3 placedBy(const OrganSource& source, const Aabb& box) {
  const Vec3 onTable(-box.centre().x(), -box.min.y(), -box.centre().z());
  return source.onTable ? onTable + source.pose.position : source.pose.position;
}

std::string boxText(const Aabb& box) {
  return fmt::format("[[{:.3f}, {:.3f}, {:.3f}], [{:.3f}, {:.3f}, {:.3f}]] m", box.min.x(),
                     box.min.y(), box.min.z(), box.max.x(), box.max.y(), box.max.z());
}

TriangleMesh hollowed(TriangleMesh organ, const OrganSource& source, const ModelReader& readModel,
                      std::vector<std::string>* notes) {
  TriangleMesh cavities;
  for (const BroughtStructure& one : source.structures) {
    if (one.kind != StructureKind::Cavity) continue;
    TriangleMesh cavity = ownSurface(one, readModel);
    const double taken = commonVolume(organ, cavity);
    if (taken == 0)
      throw error(
          "{}: the cavity fills {}, where the organ has no tissue (it fills {}); check its unit, "
          "and whether it was made in the organ's coordinates",
          one.file, boxText(bounds(cavity)), boxText(bounds(organ)));
    if (notes)
      notes->push_back(
          fmt::format("{}: a cavity of {:.3g} ml holds no tissue", one.file, 1e6 * taken));
    flip(cavity);
    append(cavities, cavity);
  }
  append(organ, cavities);
  return organ;
}

std::string namedStructuresNote(const Model& model, const OrganSource& source) {
  if (!source.part.empty() || !source.structures.empty() || model.parts.size() < 2) return "";
  std::string options;
  for (const ModelPart& part : model.parts) {
    const auto kind = structureKind(part.name);
    if (!kind || *kind == StructureKind::Parenchyma) continue;
    const std::string role =
        fmt::format("{}={}", wordOf(*kind), shownText(part.name, kLongestName));
    options += " --structure " + (role.find(' ') == role.npos ? role : "\"" + role + "\"");
  }
  if (options.empty()) return "";
  return "all parts are taken for the organ's tissue; some have names of structures, which get "
         "their roles by" +
         options;
}

void addLabels(Discretization& cells, const OrganSource& source, const std::optional<Pose>& place,
               const ModelReader& readModel, std::vector<std::string>* notes) {
  constexpr std::int64_t kFew = 30;  // about three cells across
  cells.landmarks.insert(cells.landmarks.end(), source.landmarks.begin(), source.landmarks.end());
  RegionPlacer placer(cells);
  for (const OrganLabel& one : source.labels) {
    requireMarked(
        markCells(cells, one.label, placer(one.region)), cells,
        fmt::format("label {}{}", one.label, one.name.empty() ? "" : " (" + one.name + ")"),
        "move or enlarge its region");
    if (!one.name.empty()) cells.nameLabel(one.label, one.name);
  }
  for (const BroughtStructure& one : source.structures) {
    if (one.label == 0) continue;
    const TriangleMesh surface = placedSurface(one, place, readModel);
    const std::int64_t marked = markInside(cells, one.label, surface);
    requireMarked(
        marked, cells,
        fmt::format("{}: the {} fills {} and", one.file, one.name, boxText(bounds(surface))),
        "check its unit, and whether it was made in the organ's coordinates");
    cells.nameLabel(one.label, one.name);
    if (notes && marked < kFew)
      notes->push_back(fmt::format(
          "{}: the {} has only {} particle{}, which hardly show{} its shape; use smaller cells "
          "(--spacing)",
          one.file, one.name, marked, marked == 1 ? "" : "s", marked == 1 ? "s" : ""));
  }
  if (!source.labels.empty() || !source.structures.empty()) labelSkin(cells);
}

std::shared_ptr<const VesselMap> vesselsOf(const OrganSource& source,
                                           const std::optional<Pose>& place,
                                           const TriangleMesh& surface,
                                           const ModelReader& readModel,
                                           std::vector<std::string>* notes) {
  std::array<std::vector<VesselSegment>, kVesselKinds> kinds;
  for (const BroughtStructure& one : source.structures) {
    const auto kind = vesselKind(one.kind);
    if (!kind) continue;
    std::vector<VesselSegment> tree =
        centreLines(solidShape(placedSurface(one, place, readModel), kVesselCell), *kind);
    if (tree.empty())
      throw error("{}: no vessel is as wide as {:g} mm; check its unit, or draw its vessels wider",
                  one.file, 4e3 * kVesselCell);
    append(kinds[std::size_t(*kind)], std::move(tree));
  }
  const bool both = !kinds[std::size_t(VesselKind::PortalVein)].empty() &&
                    !kinds[std::size_t(VesselKind::HepaticVein)].empty();
  const bool brought =
      std::ranges::any_of(kinds, [](const auto& segments) { return !segments.empty(); });
  const Anatomy own = ownVessels(source, place, brought ? nullptr : notes);
  std::vector<VesselSegment> all;
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    if (kinds[k].empty()) {
      const VesselRange range = own.ranges[k];
      for (VesselSegment s :
           std::span(own.segments).subspan(std::size_t(range.first), std::size_t(range.count))) {
        if (s.parent >= 0) s.parent -= range.first;
        kinds[k].push_back(s);
      }
    }
    append(all, std::move(kinds[k]));
  }
  if (all.empty()) return {};
  Anatomy anatomy = makeAnatomy(std::move(all));
  if (both && source.smallVessels && !surface.triangles.empty())
    anatomy = withSmallVessels(std::move(anatomy), surface, notes);
  return makeVesselMap(std::move(anatomy));
}

}  // namespace resect
