// Applies edits to an organ. All edits of tissue are applied by this one function.
#pragma once

#include <span>
#include <vector>

#include "organ/edit.h"
#include "organ/operated_organ.h"

namespace resect {

// Result of the edits that were applied to an organ.
struct EditSummary {
  std::int64_t removed = 0;           // number of particles removed
  double removedVolume = 0;           // their volume, skin cells included, m^3
  std::int64_t severed = 0;           // number of bonds severed by SeverBond and TearBond
  std::int64_t incised = 0;           // number of bonds severed by Incision
  std::vector<std::int32_t> vessels;  // vessel segments that were cut, or cut further
  std::vector<VesselClip> slipped;    // clips that slipped off these vessels
};

// Applies the edits of organ `number`, in the order of `edits`. Skips these edits:
// - an edit of a particle or bond that no longer exists, as when two tools remove the same
//   particle;
// - an edit of a cell or vessel segment that does not exist;
// - a Grip or Release without a tool.
// The field and the surface are updated by the next updateField() and updateSurface(). The cells of
// removed particles are appended to `removedCells`.
EditSummary applyEdits(OperatedOrgan& organ, std::int32_t number, std::span<const TissueEdit> edits,
                       std::vector<std::int64_t>& removedCells);

}  // namespace resect
