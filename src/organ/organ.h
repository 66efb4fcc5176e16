// What is an organ while it is operated on? Its cells, the colour field they make, the surface that
// is seen.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sph/colour_field.h"
#include "sph/discretization.h"
#include "surface/blade_raster.h"
#include "surface/surface_tracker.h"

namespace resect {

// One surgical act on tissue, queued by a tool and applied by the organ in one stage of the step.
struct TissueEdit {
  enum class Kind : std::uint8_t {
    Remove,  // the particle of the cell is taken out
    Sever,   // its bond in `direction` is cut; for tissue that moves
    Incise,  // the surface is parted where the tool's edge has passed; no cell
    Grip,    // the tool takes hold of it
    Release  // the tool lets go of all that it holds; no cell
  };
  Kind kind = Kind::Remove;
  std::int32_t tool = -1;       // who did it: index of the tool, -1 for nobody
  std::int64_t cell = -1;       // lattice index of a particle
  std::int32_t direction = -1;  // of a bond: tissue/stencil.h
};

struct OrganSettings {
  // Nodes of the colour field per cell, 1 to 4: 1 is coarse and fast; 2 shows the skin to a tenth
  // of a cell; more costs memory and time with the square and shows hardly more.
  int refine = 2;
  // Iso level of the surface, kMinIso to kMaxIso: lower swells the organ, higher shrinks it; 50
  // keeps the volume.
  float iso = 50;
};

// What the edits of a stage did.
struct EditSummary {
  std::int64_t removed = 0;  // particles
  double removedVolume = 0;  // m^3, with the skin's share
};

// A particle is a cell whose centre was inside the mesh. The skin cells outside, which hold the
// rest of the volume, each belong to a particle beside them and go with it, so that the volumes of
// all particles add up to the organ's. A skin cell with no particle beside it (a feather edge
// thinner than the lattice) is treated as a particle of its own.
struct Organ {
  Discretization rest;  // as built; never changes
  ColourField field;    // of the tissue that is left
  SurfaceTracker surface;
  SeveredEdges severed;             // what blades went through
  std::vector<std::uint8_t> alive;  // per cell: 1 where a particle is and has not been removed
  std::int64_t particles = 0;       // alive now
  std::int64_t removed = 0;         // since built
  double removedVolume = 0;         // m^3 since built

  double volume() const { return rest.volume() - removedVolume; }  // m^3 left
  std::size_t bytes() const;  // memory held: cells, field, surface, wounds
};

// Throws Error when `cells` holds no tissue, or a setting is out of range.
Organ makeOrgan(Discretization cells, const OrganSettings& settings);

// The particle that a cell of tissue belongs to: itself, or for a skin cell the particle beside it
// (the nearest; among equals the fullest, then the first).
std::int64_t ownerCell(const Discretization& rest, std::int64_t cell);

// Volume of a particle with its skin cells, m^3.
double particleVolume(const Discretization& rest, std::int64_t cell);

// Takes out the particles that are to be removed; those already gone are passed over. The field
// follows with updateField(). What is to be done to bonds and by grips concerns the tissue model.
EditSummary applyEdits(Organ& organ, std::span<const TissueEdit> edits);

// Cuts along the blade without taking anything away; the surface follows with updateSurface(). The
// first one is for tissue at rest; in the second, `place` tells where the nodes of the bricks are
// now. Returns the number of grid edges severed.
std::int64_t incise(Organ& organ, const SweptBlade& blade);
std::int64_t incise(Organ& organ, const SweptBlade& blade, std::span<const std::int64_t> bricks,
                    const PlaceNodes& place);

// Evaluates the touched bricks, then meshes them.
std::span<const std::int64_t> updateField(Organ& organ);
void updateSurface(Organ& organ, std::span<const std::int64_t> touchedBricks);
// Another iso level: meshes all again.
void setIso(Organ& organ, float iso);

}  // namespace resect
