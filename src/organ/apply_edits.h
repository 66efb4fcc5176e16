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
  double removedVolume = 0;  // m^3, with the skin's share
  std::int64_t severed = 0;  // bonds
};

// Applies the edits for the organ of this number, in their order. Edits of something that is gone
// already are skipped (two tools may take the same particle); so are edits of a cell that does not
// exist, and a grip or release without a tool. Field and surface follow with updateField() and
// updateSurface(). Removed particles are appended to `removedCells`.
EditSummary applyEdits(OperatedOrgan& organ, std::int32_t number, std::span<const TissueEdit> edits,
                       std::vector<std::int64_t>& removedCells);

}  // namespace resect
