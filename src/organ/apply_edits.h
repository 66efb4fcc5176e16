// The only function by which edits change tissue.
#pragma once

#include <span>
#include <vector>

#include "organ/edit.h"
#include "organ/operated_organ.h"

namespace resect {

// What the edits did to an organ.
struct EditSummary {
  std::int64_t removed = 0;           // particles
  double removedVolume = 0;           // m^3, skin cells included
  std::int64_t severed = 0;           // bonds, by edits SeverBond and TearBond
  std::int64_t incised = 0;           // bonds, by edits Incision
  std::vector<std::int32_t> vessels;  // segments of vessels that were cut
};

// Applies those edits that are for organ `number`, in the order of `edits`. These edits are
// skipped:
// - an edit of something that is already gone, since two tools may take the same particle;
// - an edit of a cell that does not exist;
// - a Grip or Release without a tool.
// Field and surface follow at the next updateField() and updateSurface(). The cells of removed
// particles are appended to `removedCells`.
EditSummary applyEdits(OperatedOrgan& organ, std::int32_t number, std::span<const TissueEdit> edits,
                       std::vector<std::int64_t>& removedCells);

}  // namespace resect
