// The one place where tissue is changed by edits.
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

// Applies those edits that are for the organ of this number, in their order. What is gone already
// is passed over, two tools may take the same particle; so is what names a cell that there is not,
// and a grip or a release by nobody. Field and surface follow with updateField()
// and updateSurface(). `removedCells`: the particles that were there and are no more are appended.
EditSummary applyEdits(OperatedOrgan& organ, std::int32_t number, std::span<const TissueEdit> edits,
                       std::vector<std::int64_t>& removedCells);

}  // namespace resect
