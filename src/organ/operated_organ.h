// An organ on the table: its cells and surface, how its tissue moves, where its surface is now.
#pragma once

#include <memory>
#include <string>

#include "organ/organ.h"
#include "organ/skin.h"
#include "tissue/tissue_model.h"

namespace resect {

struct OperatedOrgan {
  std::string name;
  Organ organ;
  std::unique_ptr<TissueModel> tissue;
  SurfaceSkin skin;  // of tissue that moves

  // One point, and after Simulation::keepLook() one normal, per vertex of the surface's arrays.
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
    v.made(name, tissue, skin);
  }
};

// tissue: null for one that does not move.
OperatedOrgan operatedOrgan(std::string name, Organ organ,
                            std::unique_ptr<TissueModel> tissue = nullptr);

// After a state was loaded into `organ.organ` and its tissue: field, surface and skin follow.
// Throws Error when the state does not fit.
void remake(OperatedOrgan& organ, bool keepsLook);

// Of what was there before any operation: two organs of the same fingerprint can have each other's
// states.
std::uint64_t fingerprint(const Organ& organ);

}  // namespace resect
