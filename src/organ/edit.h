// What can be done to tissue? Edits: each says what, to which organ, and carries all that it takes.
//
// Instruments queue them, and so may a script, a test, whoever takes something back: who made an
// edit makes no difference. They are applied in the order in which they were queued, in one place
// (organ/apply_edits.h). A new kind is a struct here and a function there.
#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "collision/swept_blade.h"
#include "geometry/pose.h"

namespace resect {

// Cells are named by their index in the organ's lattice, directions of bonds as in
// tissue/stencil.h.

struct RemoveCell {  // its particle is taken out
  std::int64_t cell = -1;
};
struct SeverBond {
  std::int64_t cell = -1;
  std::int32_t direction = -1;
};
struct Incision {                   // the surface is parted where a blade has passed
  SweptBlade blade;                 // world, where the tissue is now
  std::vector<std::int64_t> cells;  // particles near it, ascending
};
struct Grip {  // the tool takes hold of the cell, where both are
  std::int64_t cell = -1;
  Pose pose;  // of the tool
};
struct Release {};  // the tool lets go of all that it holds
struct SetLabel {   // the cell belongs to another structure (organ/cell_fields.h)
  std::int64_t cell = -1;
  std::uint8_t label = 0;
};

struct TissueEdit {
  std::int32_t organ = 0;  // its number in the simulation
  std::int32_t tool = -1;  // who did it: number of the tool, -1 for nobody
  std::variant<RemoveCell, SeverBond, Incision, Grip, Release, SetLabel> what;
};

}  // namespace resect
