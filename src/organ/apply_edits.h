// Applies edits to an organ: the only function by which edits change tissue.
#pragma once

#include <span>
#include <vector>

#include "organ/edit.h"
#include "organ/operated_organ.h"

namespace resect {

// What the edits did to an organ.
struct EditSummary {
  std::int64_t removed = 0;  // particles
  double removedVolume = 0;  // m^3, skin cells included
  std::int64_t severed = 0;  // bonds
};

// Applies those of the edits that are for organ `number`, in their order. An edit of something that
// is already gone is skipped (two tools may take the same particle), and so is an edit of a cell
// that does not exist, or a grip or release without a tool. Field and surface follow at the next
// updateField() and updateSurface(). The cells of removed particles are appended to `removedCells`.
EditSummary applyEdits(OperatedOrgan& organ, std::int32_t number, std::span<const TissueEdit> edits,
                       std::vector<std::int64_t>& removedCells);

}  // namespace resect
