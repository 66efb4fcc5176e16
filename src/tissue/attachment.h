// Attachments: regions of an organ that are pinned or held by a ligament. Given in rest space, so
// that they hold at any spacing.
#pragma once

#include "sph/region.h"

namespace resect {

// The region's cells are held; it must be placed (sph/region.h) before tissue is attached.
struct TissueAttachment : Region {
  enum class Kind {
    Pin,      // the cells do not move
    Ligament  // a spring pulls each cell to its rest position
  };
  Kind kind = Kind::Pin;
  double stiffness = 200;  // of the whole ligament, N/m, spread over its cells
};

}  // namespace resect
