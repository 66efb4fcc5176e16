// An organ during an operation: its cells, their colour field, and the surface.
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
  // Nodes of the colour field per cell along each axis, 1 to 4: 1 is coarse and fast; 2 gives the
  // surface to a tenth of a cell; more costs memory and time that grow with the square, and
  // improves little.
  int refine = 2;
  // Iso level of the surface, kMinIso to kMaxIso: lower enlarges the organ, higher shrinks it; 50
  // keeps the volume.
  float iso = 50;

  template <class Visitor>
  void visit(Visitor& v) {
    v("refine", refine), v("iso", iso);
  }
};

// A particle is a cell whose centre was inside the mesh. Skin cells hold the rest of the volume.
// Each belongs to a neighbouring particle and is removed with it, so that the volumes of all
// particles add up to the organ's. A skin cell without a neighbouring particle, where the organ is
// thinner than the lattice can show, is treated as a particle.
struct Organ {
  Discretization rest;  // as built; never changes
  ColourField field;    // of the tissue that is left
  SurfaceTracker surface;
  SeveredEdges severed;             // grid edges severed by blades and tears
  std::vector<std::uint8_t> alive;  // per cell: 1 where a particle is and has not been removed
  std::int64_t particles = 0;       // alive now
  std::int64_t removed = 0;         // particles, since the organ was made
  double removedVolume = 0;         // m^3, since the organ was made
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

// The particle that a cell of tissue belongs to. A particle belongs to itself, a skin cell to a
// neighbouring particle (the nearest; among equals the fullest, then the first), or to itself if it
// has none.
std::int64_t ownerCell(const Discretization& rest, std::int64_t cell);

// Volume of a particle with its skin cells, m^3.
double particleVolume(const Discretization& rest, std::int64_t cell);

// Removes the particle in `cell`; there must be one. The field follows at the next updateField();
// the bonds are left to the tissue model.
struct RemovedParticle {
  std::int64_t particles = 0;  // 1; 0 for a skin cell without a particle
  double volume = 0;           // m^3, with its skin cells
};
RemovedParticle removeParticle(Organ& organ, std::int64_t cell);
// Sets the colour values of the particle's cell and of its skin cells: to those at rest if `there`,
// else to 0.
void setParticle(Organ& organ, std::int64_t cell, bool there);

// Cuts along the blade without removing anything; the surface follows at the next updateSurface().
// The first overload is for tissue at rest. The second cuts in `bricks` only, and `place` gives the
// present positions of their nodes. Returns the number of grid edges severed.
std::int64_t incise(Organ& organ, const SweptBlade& blade);
std::int64_t incise(Organ& organ, const SweptBlade& blade, std::span<const std::int64_t> bricks,
                    const PlaceNodes& place);

// updateField() evaluates the bricks that edits touched and returns them; updateSurface() then
// meshes them.
std::span<const std::int64_t> updateField(Organ& organ);
void updateSurface(Organ& organ, std::span<const std::int64_t> touchedBricks);
// Sets another iso level and meshes everything again.
void setIso(Organ& organ, float iso);

}  // namespace resect
