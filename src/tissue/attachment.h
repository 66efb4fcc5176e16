// Attachments: regions of an organ that are pinned or held by a ligament. A region is given by
// geometry in rest space, so an attachment can be used with any size of the tissue's cells.
#pragma once

#include "sph/region.h"

namespace resect {

// Holds the cells in its region. The region must be placed (Region::isPlaced()) before the
// attachment is given to ElasticTissue::attach().
struct TissueAttachment : Region {
  enum class Kind {
    Pin,      // cells wholly in the region do not move; a spring holds each cell partly in it
    Ligament  // a spring pulls each cell to its rest position, if its centre is in the region
  };
  Kind kind = Kind::Pin;
  // For a ligament: the stiffness of all its springs together, N/m. Each spring gets an equal
  // share, or less if that would be unstable.
  double stiffness = 200;

  template <class Visitor>
  void visit(Visitor& v) {
    Region::visit(v);
    v("kind", kind), v("stiffness", stiffness);
  }
};

}  // namespace resect
