#include "organ/apply_edits.h"

#include "organ/moved_incision.h"
#include "organ/strands.h"

namespace resect {
namespace {

// What each kind of edit does. Bonds and blades are remembered: where they went through, strands of
// surface are parted once all is done.
struct Application {
  OperatedOrgan& to;
  std::int32_t tool = -1;
  EditSummary summary;
  std::vector<std::int64_t>& removedCells;
  std::vector<TissueBond> severed;
  std::vector<std::int64_t> nearBlades;

  void operator()(const RemoveCell& edit) {
    if (!to.organ.alive[std::size_t(edit.cell)]) return;
    const RemovedParticle gone = removeParticle(to.organ, edit.cell);
    summary.removed += gone.particles;
    summary.removedVolume += gone.volume;
    to.tissue->remove(edit.cell);
    removedCells.push_back(edit.cell);
  }
  void operator()(const SeverBond& edit) {
    if (!(to.tissue->bonds(edit.cell) >> edit.direction & 1)) return;
    to.tissue->sever(edit.cell, edit.direction);
    severed.push_back({edit.cell, edit.direction});
  }
  void operator()(const Incision& edit) {
    inciseMoved(to.organ, *to.tissue, edit.blade, edit.cells);
    nearBlades.insert(nearBlades.end(), edit.cells.begin(), edit.cells.end());
  }
  void operator()(const Grip& edit) { to.tissue->grip(edit.cell, tool, edit.pose); }
  void operator()(const Release&) { to.tissue->release(tool); }
  void operator()(const SetLabel& edit) {
    to.organ.fields.label.set(to.organ.rest.lattice, edit.cell, edit.label);
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
