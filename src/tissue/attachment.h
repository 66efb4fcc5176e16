// Attachments: regions of an organ that are pinned or held by a ligament. A region is given by
// geometry in rest space, so an attachment is valid at any spacing.
#pragma once

#include "sph/region.h"

namespace resect {

// Holds the cells of a region. The region must be placed (Region::isPlaced()) before tissue is
// attached.
struct TissueAttachment : Region {
  enum class Kind {
    Pin,      // the cells do not move
    Ligament  // a spring pulls each cell to its rest position
  };
  Kind kind = Kind::Pin;
  double stiffness = 200;  // of the whole ligament, N/m; its cells' springs share it equally

  template <class Visitor>
  void visit(Visitor& v) {
    Region::visit(v);
    v("kind", kind), v("stiffness", stiffness);
  }
};

}  // namespace resect
