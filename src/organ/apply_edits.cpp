#include "organ/apply_edits.h"

#include <algorithm>

#include "organ/incision/strands.h"
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
    const RemovedParticle gone = removeParticle(to.organ, edit.cell);
    summary.removed += gone.particles;
    summary.removedVolume += gone.volume;
    to.tissue->remove(edit.cell);
    removedCells.push_back(edit.cell);
  }
  void operator()(const SeverBond& edit) {
    if (!there(edit.cell) || edit.direction < 0 || edit.direction >= kDirections) return;
    if (!(to.tissue->bonds(edit.cell) >> edit.direction & 1)) return;
    to.tissue->sever(edit.cell, edit.direction);
    severed.push_back({edit.cell, edit.direction});
  }
  void operator()(const Incision& edit) {
    const Lattice& lattice = to.organ.rest.lattice;
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
  partStrands(organ.organ, *organ.tissue, application.severed, application.nearBlades);
  organ.tissue->settle();
  application.summary.severed = std::int64_t(application.severed.size());
  return application.summary;
}

}  // namespace resect
