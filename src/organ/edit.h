// Edits: changes to tissue. Each edit is a value with the number of its organ and all data that it
// needs.
//
// Instruments queue edits. A script, a test or an undo may queue edits, too. The effect of an edit
// does not depend on who made the edit. Edits are applied in the order in which they were queued,
// by one function (organ/apply_edits.h). A new kind of edit needs a struct here and a function in
// organ/apply_edits.cpp.
#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "collision/swept_blade.h"
#include "geometry/pose.h"
#include "sph/node_caps.h"

namespace resect {

// How edits name things: a cell is given by its index in the organ's lattice. The direction of a
// bond is given by its number in tissue/stencil.h. A vessel segment is given by its index in the
// organ's anatomy.

struct RemoveCell {  // removes the particle of the cell
  std::int64_t cell = -1;
  double spares = 1;  // m: vessels with at least this radius are left bare, not cut
};
struct SeverBond {  // severs the bond of the cell in this direction
  std::int64_t cell = -1;
  std::int32_t direction = -1;
};
struct Incision {    // cuts the surface along a blade, and the bonds that cross the blade
  SweptBlade blade;  // in rest space, m
};
struct Grip {  // the cell keeps its present position relative to the tool from now on
  std::int64_t cell = -1;
  Pose pose;  // of the tool, at the start of the frame
};
struct Release {};  // the tool releases all cells of the organ that it grips
struct SetLabel {   // the cell gets another label (organ/cell_fields.h)
  std::int64_t cell = -1;
  std::uint8_t label = 0;
};

struct PlaceClip {  // closes a vessel at a point of a segment
  std::int32_t segment = -1;
  double share = 0;  // distance from the segment's start as a fraction of its length, 0 to 1
};
struct Heat {                 // heats tissue for the whole frame (heat/heat_field.h)
  Vec3 place = Vec3::Zero();  // centre of the heated ball, rest space, m
  double radius = 0;          // m
  double power = 0;           // W
};
struct ClampInflow {  // closes or opens portal vein and artery before they enter the organ
  bool closed = true;
};
struct Suction {              // sucks up blood for the whole frame
  Vec3 place = Vec3::Zero();  // world, m
  double radius = 0;          // m
  double rate = 0;            // greatest rate at which blood is sucked up, m^3/s
};

struct Press {                // presses on bleeding vessels for the whole frame, and soaks up blood
  Vec3 place = Vec3::Zero();  // world, m
  double radius = 0;          // m
  double pressure = 0;        // Pa
  double soaks = 0;           // greatest rate at which blood is soaked up, m^3/s
};
struct DivideVessel {  // cuts through a vessel at a point of a segment
  std::int32_t segment = -1;
  double share = 0;  // distance from the segment's start as a fraction of its length, 0 to 1
};

// Severs a bond as SeverBond does, but does not cut vessels with a radius of at least `spares`, m.
// These vessels are left bare.
struct TearBond {
  std::int64_t cell = -1;
  std::int32_t direction = -1;
  double spares = 1;
};

// Takes away tissue along the path of a round instrument, finer than the cells (organ/carving.h).
// Removes each particle of which less than half is left.
struct Carve {
  CarvedLine line;
  double spares = 1;  // m: vessels with at least this radius are left bare, not cut
};

struct TissueEdit {
  std::int32_t organ = 0;  // number of the organ in the simulation
  std::int32_t tool = -1;  // number of the tool that made it; -1: none
  std::variant<RemoveCell, SeverBond, Incision, Grip, Release, SetLabel, PlaceClip, Heat,
               ClampInflow, Suction, Press, DivideVessel, TearBond, Carve>
      what;
};

}  // namespace resect
