// An organ during an operation: its cells, their colour field, and the surface.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "anatomy/vessel_map.h"
#include "anatomy/vessel_state.h"
#include "heat/heat_field.h"
#include "organ/cell_fields.h"
#include "sph/colour_field.h"
#include "sph/discretization.h"
#include "sph/node_caps.h"
#include "surface/surface_tracker.h"
#include "wound/blade_raster.h"

namespace resect {

struct OrganSettings {
  // Nodes of the colour field per cell along each axis, 1 to 4. Memory and time grow with the
  // square of this number. With 1 the surface is coarse. With 2 it is accurate to a tenth of a
  // cell. With 3 or 4 it is only a little better.
  int refine = 2;
  // Iso level of the surface, kMinIso to kMaxIso. A lower level enlarges the organ, and a higher
  // level shrinks it. The level 50 keeps the volume.
  float iso = 50;

  template <class Visitor>
  void visit(Visitor& v) {
    v("refine", refine), v("iso", iso);
  }
};

// A particle is a cell whose centre was inside the mesh from which the organ was made. Skin cells,
// whose centres were outside, hold the rest of the tissue. Each skin cell belongs to a neighbouring
// particle. It is removed with this particle, and its volume is a part of the particle's volume. So
// the volumes of all particles add up to the organ's volume. Where the organ is thinner than the
// lattice can show, a skin cell may have no neighbouring particle. Such a skin cell is treated as a
// particle.
struct Organ {
  Discretization rest;  // as built; never changes
  ColourField field;    // of the tissue that is left
  SurfaceTracker surface;
  SeveredEdges severed;             // grid edges severed by blades and tears
  std::vector<std::uint8_t> alive;  // per cell: 1 where there is a particle now
  NodeCaps carved;                  // where instruments have carved (organ/carving.h)
  // Per cell: 1 where carving has left the remnant of a particle. Empty: there has been none.
  std::vector<std::uint8_t> remnant;
  std::int64_t particles = 0;  // number of particles now
  std::int64_t removed = 0;    // number of particles removed since the organ was made
  double removedVolume = 0;    // volume removed since the organ was made, m^3
  float iso = 50;              // iso level of the surface
  float kerf = 0;              // width of the gap that cuts leave, m (wound/wound_brick.h)
  CellFields fields;
  std::shared_ptr<const VesselMap> map;  // vessels at rest; null: none are known
  VesselState vessels;                   // injuries, clips and bared segments
  HeatField heat;

  double volume() const { return rest.volume() - removedVolume; }  // of the tissue left, m^3
  // The cell's present label.
  std::uint8_t label(std::int64_t cell) const { return fields.label[cell]; }

  template <class Visitor>
  void visit(Visitor& v) {
    v.perCell("alive", alive, rest.lattice.order());
    v("carved", carved), v.perCell("remnant", remnant, rest.lattice.order());
    fields.visit(v, rest.lattice.order());
    v("vessels", vessels), v("heat", heat);
    v("severed", severed), v("iso", iso);
    v("particles", particles), v("removed", removed), v("removedVolume", removedVolume);
  }
  template <class Visitor>
  void visitMade(Visitor& v) {
    v.made(rest, field, surface, map);
    carved.visitMade(v);
  }
};

// Makes the organ before the operation. Throws Error if `cells` has no particle, its lattice is too
// large, or a setting is out of range.
Organ makeOrgan(Discretization cells, const OrganSettings& settings);

// The particle that a cell with tissue belongs to. A particle belongs to itself. A skin cell
// belongs to the nearest of its neighbouring particles. If several of these are equally near, it
// belongs to the fullest of them. If several of them are equally full, it belongs to the particle
// with the lowest index. A skin cell without a neighbouring particle belongs to itself.
std::int64_t ownerCell(const Discretization& rest, std::int64_t cell);

// Calls visit(cell) for the particle's cell and for each of its skin cells.
void visitCellsOf(const Discretization& rest, std::int64_t particle,
                  const std::function<void(std::int64_t)>& visit);

// Volume of the tissue in a particle and in its skin cells, m^3.
double particleVolume(const Discretization& rest, std::int64_t cell);

// Result of removeParticle().
struct RemovedParticle {
  std::int64_t particles = 0;  // 1, or 0 if it was a skin cell without a particle
  double volume = 0;           // of the particle and its skin cells, m^3
};
// Removes the particle in `cell`; there must be one. The next updateField() updates the field. The
// caller must remove the cell from the tissue model.
RemovedParticle removeParticle(Organ& organ, std::int64_t cell);
// Sets the colour values of the particle's cell and of its skin cells. If `there` is true, the
// cells get the values that they had before the operation. If not, they get the value 0.
void setParticle(Organ& organ, std::int64_t cell, bool there);

// Severs the grid edges along the blade without removing anything. The surface shows the cut after
// the next updateSurface(). blade: in rest space. cuts: see wound/blade_raster.h. Returns the
// number of grid edges severed.
std::int64_t incise(Organ& organ, const SweptBlade& blade,
                    CutsBetweenCells cuts = CutsBetweenCells::Any);

// updateField() evaluates the bricks (blocks of 4 x 4 x 4 nodes) that edits touched, and returns
// these bricks. updateSurface() then meshes them again.
std::span<const std::int64_t> updateField(Organ& organ);
void updateSurface(Organ& organ, std::span<const std::int64_t> touchedBricks);
// Does the same as updateSurface(); to be called instead after a state was restored.
void updateRestoredSurface(Organ& organ, std::span<const std::int64_t> touchedBricks);
// Sets another iso level and meshes the whole surface again.
void setIso(Organ& organ, float iso);

}  // namespace resect
