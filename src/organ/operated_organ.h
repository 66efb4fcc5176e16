// An organ in an operation: its cells and surface at rest, its tissue model, and the present
// surface, which has moved with the tissue.
#pragma once

#include <memory>
#include <string>

#include "organ/organ.h"
#include "organ/skin/skin.h"
#include "tissue/cord.h"
#include "tissue/tissue_model.h"

namespace resect {

// A cord that stands for the wall of a vessel between two cells.
struct VesselCord {
  TissueCord cord;
  std::int32_t segment = -1;  // index in the organ's anatomy
  // The place at which the segment enters the cell cord.b, as a fraction of the segment's length.
  double share = 0;
};

struct OperatedOrgan {
  std::string name;
  Organ organ;
  std::unique_ptr<TissueModel> tissue;
  SurfaceSkin skin;                         // used if the tissue moves
  std::vector<VesselCord> cords;            // the tissue's present cords
  std::vector<std::uint8_t> remnantBefore;  // Organ::remnant at the last beginRestore()

  // points() gives one point per vertex of the surface's arrays. After Simulation::keepLook(),
  // normals() gives one normal per vertex.
  std::span<const Vec3f> points() const {  // world, m
    return tissue->moves() ? skin.points() : organ.surface.points();
  }
  std::span<const Vec3f> normals() const {  // unit, outwards
    return tissue->moves() ? skin.normals() : organ.surface.normals();
  }
  std::size_t bytes() const;  // memory held

  template <class Visitor>
  void visit(Visitor& v) {
    v("organ", organ), v("tissue", *tissue);
  }
  template <class Visitor>
  void visitMade(Visitor& v) {
    v.made(name, tissue, skin, cords, remnantBefore);
  }
};

// Makes an operated organ. tissue: null for still tissue.
OperatedOrgan operatedOrgan(std::string name, Organ organ,
                            std::unique_ptr<TissueModel> tissue = nullptr);

// Call before a state is loaded into `organ.organ` and `organ.tissue`.
void beginRestore(OperatedOrgan& organ);
// Call after a state was loaded into `organ.organ` and `organ.tissue`. Derives field, surface and
// skin from the state; if keepsLook is true, also normals and cut shares (isosurface/brick_look.h).
// anew: if true, the whole surface is meshed again; if false, only the parts that differ from the
// present surface. `anew` must be true if a computation was stopped and left field, surface or
// skin half changed (base/stop.h). Throws Error if the state does not fit the organ.
void remake(OperatedOrgan& organ, bool keepsLook, bool anew);

// Fingerprint of the organ before the operation. A state saved from an organ can be restored into
// any organ with an equal fingerprint.
std::uint64_t fingerprint(const Organ& organ);

}  // namespace resect
