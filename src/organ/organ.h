// What is an organ while it is operated on? Its cells, the colour field they make, the surface that
// is seen.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "organ/cell_fields.h"
#include "sph/colour_field.h"
#include "sph/discretization.h"
#include "surface/surface_tracker.h"
#include "wound/blade_raster.h"

namespace resect {

struct OrganSettings {
  // Nodes of the colour field per cell, 1 to 4: 1 is coarse and fast; 2 shows the skin to a tenth
  // of a cell; more costs memory and time with the square and shows hardly more.
  int refine = 2;
  // Iso level of the surface, kMinIso to kMaxIso: lower swells the organ, higher shrinks it; 50
  // keeps the volume.
  float iso = 50;
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
  float iso = 50;                   // level of the surface
  CellFields fields;

  double volume() const { return rest.volume() - removedVolume; }             // m^3 left
  std::uint8_t label(std::int64_t cell) const { return fields.label[cell]; }  // now

  template <class Visitor>
  void visit(Visitor& v) {
    v.perCell("alive", alive, rest.lattice.order());
    fields.visit(v, rest.lattice.order());
    v("severed", severed), v("iso", iso);
    v("particles", particles), v("removed", removed), v("removedVolume", removedVolume);
  }
  template <class Visitor>
  void visitMade(Visitor& v) {
    v.made(rest, field, surface);
  }
};

// Throws Error when `cells` holds no tissue, or a setting is out of range.
Organ makeOrgan(Discretization cells, const OrganSettings& settings);

// The particle that a cell of tissue belongs to: itself, or for a skin cell the particle beside it
// (the nearest; among equals the fullest, then the first).
std::int64_t ownerCell(const Discretization& rest, std::int64_t cell);

// Volume of a particle with its skin cells, m^3.
double particleVolume(const Discretization& rest, std::int64_t cell);

// Takes a particle out that is there; the field follows with updateField(). What becomes of its
// bonds is the tissue model's.
struct RemovedParticle {
  std::int64_t particles = 0;  // 1; 0 for a skin cell of its own
  double volume = 0;           // m^3, with its skin cells
};
RemovedParticle removeParticle(Organ& organ, std::int64_t cell);
// Gives its cells the colour values that they have at rest, or none.
void setParticle(Organ& organ, std::int64_t cell, bool there);

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
