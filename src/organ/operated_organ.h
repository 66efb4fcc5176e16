// An organ in an operation: its cells and surface, its tissue model, and the surface as the moved
// tissue carries it.
#pragma once

#include <memory>
#include <string>

#include "organ/organ.h"
#include "organ/skin/skin.h"
#include "tissue/cord.h"
#include "tissue/tissue_model.h"

namespace resect {

// The wall of a vessel between two cells: a place of a segment of the organ's anatomy as a cord.
struct VesselCord {
  TissueCord cord;
  std::int32_t segment = -1;
  double share = 0;  // of the segment's length, of the middle
};

struct OperatedOrgan {
  std::string name;
  Organ organ;
  std::unique_ptr<TissueModel> tissue;
  SurfaceSkin skin;               // used if the tissue moves
  std::vector<VesselCord> cords;  // as the tissue has them

  // points() has one point per vertex of the surface's arrays. After Simulation::keepLook(),
  // normals() has one normal per vertex.
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
    v.made(name, tissue, skin, cords);
  }
};

// tissue: null for still tissue.
OperatedOrgan operatedOrgan(std::string name, Organ organ,
                            std::unique_ptr<TissueModel> tissue = nullptr);

// Call after a state was loaded into `organ.organ` and `organ.tissue`. Derives field, surface and
// skin from it; with keepsLook, also normals and cut shares. Throws Error if the state does not fit
// the organ.
void remake(OperatedOrgan& organ, bool keepsLook);

// Fingerprint of the organ before the operation. A state saved from an organ can be restored into
// any organ with an equal fingerprint.
std::uint64_t fingerprint(const Organ& organ);

}  // namespace resect
