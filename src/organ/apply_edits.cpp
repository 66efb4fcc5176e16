#include "organ/apply_edits.h"

#include <algorithm>

#include "anatomy/vessel_closure.h"
#include "organ/carving.h"
#include "organ/incision/strands.h"
#include "organ/vessel_cords.h"
#include "tissue/cut_bonds.h"
#include "tissue/stencil.h"

namespace resect {
namespace {

constexpr double kNearBlade = 2;  // spacings: how far a cut can part strands

// What each kind of edit does. Severed bonds and blades are recorded, so that strands can be
// severed after all edits.
struct Application {
  OperatedOrgan& to;
  std::int32_t tool = -1;
  EditSummary summary;
  std::vector<std::int64_t>& removedCells;
  std::vector<TissueBond> severed;
  std::vector<std::int64_t> nearBlades;

  bool there(std::int64_t cell) const {
    return cell >= 0 && cell < to.organ.rest.lattice.cellCount();
  }
  void operator()(const RemoveCell& edit) {
    if (!there(edit.cell) || !to.organ.alive[std::size_t(edit.cell)]) return;
    gone(edit.cell, removeParticle(to.organ, edit.cell), edit.spares);
  }
  void operator()(const Carve& edit) {
    for (const std::int64_t cell : carve(to.organ, edit.line))
      gone(cell, removeCarvedParticle(to.organ, cell), edit.spares);
  }
  void operator()(const SeverBond& edit) {
    if (sever(edit.cell, edit.direction) && to.organ.map && neighbourKind(edit.direction) == 1)
      cutVessels(to.organ.map->anatomy, to.organ.map->index, faceOf(edit.cell, edit.direction),
                 to.organ.vessels, summary.vessels);
  }
  void operator()(const TearBond& edit) {
    if (sever(edit.cell, edit.direction) && to.organ.map && neighbourKind(edit.direction) == 1)
      tearVessels(to.organ.map->anatomy, to.organ.map->index, faceOf(edit.cell, edit.direction),
                  edit.spares, to.organ.vessels, summary.vessels);
  }
  void operator()(const Incision& edit) {
    const Lattice& lattice = to.organ.rest.lattice;
    if (to.organ.map)
      cutVessels(to.organ.map->anatomy, to.organ.map->index, edit.blade, to.organ.vessels,
                 summary.vessels);
    incise(to.organ, edit.blade,
           to.tissue->moves() ? CutsBetweenCells::One : CutsBetweenCells::Any);
    for (const TissueBond& bond : crossedBonds(*to.tissue, lattice, edit.blade)) {
      to.tissue->sever(bond.cell, bond.direction);
      ++summary.incised;
    }
    visitCellsIn(lattice, edit.blade.bounds.padded(kNearBlade * lattice.spacing.maxCoeff()),
                 [&](const Vec3i& at) {
                   const std::int64_t cell = lattice.index(at);
                   if (to.organ.alive[std::size_t(cell)]) nearBlades.push_back(cell);
                 });
  }
  // Only tools grip; springs without a tool are permanent attachments.
  void operator()(const Grip& edit) {
    if (there(edit.cell) && tool >= 0) to.tissue->grip(edit.cell, tool, edit.pose);
  }
  void operator()(const Release&) {
    if (tool >= 0) to.tissue->release(tool);
  }
  void operator()(const SetLabel& edit) {
    if (there(edit.cell)) to.organ.fields.label.set(to.organ.rest.lattice, edit.cell, edit.label);
  }
  void operator()(const PlaceClip& edit) {
    if (to.organ.map && edit.segment >= 0 &&
        std::size_t(edit.segment) < to.organ.map->anatomy.segments.size())
      to.organ.vessels.addClip({edit.segment, std::clamp(edit.share, 0.0, 1.0)});
  }
  void operator()(const DivideVessel& edit) {
    if (to.organ.map && edit.segment >= 0 &&
        std::size_t(edit.segment) < to.organ.map->anatomy.segments.size())
      divideVessel(edit.segment, std::clamp(edit.share, 0.0, 1.0), to.organ.vessels,
                   summary.vessels);
  }
  void operator()(const ClampInflow& edit) { to.organ.vessels.inflowClamped = edit.closed; }
  void operator()(const Heat&) {}     // works for the whole frame (organ/heat_organ.h)
  void operator()(const Suction&) {}  // these two act on blood (blood/bleeding.h)
  void operator()(const Press&) {}

  // False if there was no such bond.
  bool sever(std::int64_t cell, std::int32_t direction) {
    if (!there(cell) || direction < 0 || direction >= kDirections) return false;
    if (!(to.tissue->bonds(cell) >> direction & 1)) return false;
    to.tissue->sever(cell, direction);
    severed.push_back({cell, direction});
    return true;
  }
  void gone(std::int64_t cell, const RemovedParticle& particle, double spares) {
    summary.removed += particle.particles;
    summary.removedVolume += particle.volume;
    to.tissue->remove(cell);
    removedCells.push_back(cell);
    if (!to.organ.map) return;
    const Lattice& lattice = to.organ.rest.lattice;
    const Vec3 centre = lattice.centre(lattice.cell(cell));
    cutVessels(to.organ.map->anatomy, to.organ.map->index,
               {centre - 0.5 * lattice.spacing, centre + 0.5 * lattice.spacing}, spares,
               to.organ.vessels, summary.vessels);
  }
  // The face between a cell and its neighbour.
  SweptBlade faceOf(std::int64_t cell, std::int32_t direction) const {
    const Lattice& lattice = to.organ.rest.lattice;
    const Vec3 along = offsetOf(direction).cast<double>();
    const Vec3 middle =
        lattice.centre(lattice.cell(cell)) + 0.5 * lattice.spacing.cwiseProduct(along);
    const Vec3 u = 0.5 * lattice.spacing.cwiseProduct(Vec3(along.y(), along.z(), along.x())),
               v = 0.5 * lattice.spacing.cwiseProduct(Vec3(along.z(), along.x(), along.y()));
    const Vec3 before[] = {middle - u - v, middle + u - v},
               after[] = {middle - u + v, middle + u + v};
    return ruledBlade(before, after);
  }
};

}  // namespace

EditSummary applyEdits(OperatedOrgan& organ, std::int32_t number, std::span<const TissueEdit> edits,
                       std::vector<std::int64_t>& removedCells) {
  Application application{organ, -1, {}, removedCells, {}, {}};
  bool any = false;
  for (const TissueEdit& edit : edits) {
    if (edit.organ != number) continue;
    application.tool = edit.tool;
    std::visit(application, edit.what);
    any = true;
  }
  if (!any) return {};
  if (organ.organ.map && !application.summary.vessels.empty())
    application.summary.slipped =
        slipClips(organ.organ.map->anatomy, application.summary.vessels, organ.organ.vessels);
  dropRemnants(organ.organ, removedCells);
  partStrands(organ.organ, *organ.tissue, application.severed, application.nearBlades);
  organ.tissue->settle();
  if (organ.organ.map && (!removedCells.empty() || !application.severed.empty() ||
                          !application.nearBlades.empty() || !application.summary.vessels.empty()))
    renewCords(organ);
  application.summary.severed = std::int64_t(application.severed.size());
  return application.summary;
}

}  // namespace resect
