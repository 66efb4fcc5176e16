// Edits: what can be done to tissue. Each is a value with its organ and all data that it needs.
//
// Instruments queue edits, and so may a script, a test or an undo: who made an edit makes no
// difference. Edits are applied in the order in which they were queued, by one function
// (organ/apply_edits.h). A new kind of edit is a struct here and a function in
// organ/apply_edits.cpp.
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
struct Incision {                   // cuts the surface where a blade has passed
  SweptBlade blade;                 // world, where the tissue is now
  std::vector<std::int64_t> cells;  // particles near it, ascending
};
struct Grip {  // the tool grips the cell at its present position relative to the tool
  std::int64_t cell = -1;
  Pose pose;  // of the tool, at the start of the frame
};
struct Release {};  // the tool releases all its cells
struct SetLabel {   // the cell gets another label (organ/cell_fields.h)
  std::int64_t cell = -1;
  std::uint8_t label = 0;
};

struct TissueEdit {
  std::int32_t organ = 0;  // its number in the simulation
  std::int32_t tool = -1;  // number of the tool that made it; -1: none
  std::variant<RemoveCell, SeverBond, Incision, Grip, Release, SetLabel> what;
};

}  // namespace resect
