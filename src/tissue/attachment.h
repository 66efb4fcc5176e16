// Attachments: regions of an organ that are pinned or held by a ligament. A region is given by
// geometry in rest space, so it does not depend on the size of the tissue's cells.
#pragma once

#include "sph/region.h"

namespace resect {

// Holds the cells in its region. Region::isPlaced() must be true before the attachment is given to
// ElasticTissue::attach().
struct TissueAttachment : Region {
  enum class Kind {
    // A cell of which at least 5/6 lies in the region does not move. A cell of which a smaller part
    // lies in the region is pulled to its rest position by a spring. The larger the part, the
    // stiffer is the spring (docs/methods/tissue.md, "Contact, grips, attachments").
    Pin,
    // A cell whose centre lies in the region is pulled to its rest position by a spring.
    Ligament
  };
  Kind kind = Kind::Pin;
  // For a ligament: the stiffness of all its springs together, N/m. Each spring gets an equal share
  // of this stiffness. If a spring with this share would be unstable, it gets a smaller stiffness.
  double stiffness = 200;

  template <class Visitor>
  void visit(Visitor& v) {
    Region::visit(v);
    v("kind", kind), v("stiffness", stiffness);
  }
};

}  // namespace resect
