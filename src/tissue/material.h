// Materials of tissue: stiffness, density, toughness.
//
// The material is a neo-Hookean solid with this energy per volume:
//
//     Psi(F) = mu/2 (F:F - 3) - mu (J - 1) + (lambda + mu)/2 (J - 1)^2
//
// F is the deformation gradient, J its determinant; lambda and mu are Lame's constants. At small
// strain the solid has Young's modulus E and Poisson's ratio nu. Its energy stays finite when a
// cell is inverted (after Smith, de Goes, Kim 2018, without their barrier term). Defaults and their
// sources: docs/methods/tissue.md.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sph/lattice.h"

namespace resect {

struct TissueMaterial {
  std::string name = "liver";
  double young = 5000;    // Pa, 1 to 1e9
  double poisson = 0.45;  // 0 to 0.4999; near 0.5 waves are fast, so substeps are short
  double density = 1060;  // kg/m^3, 1 to 1e5
  // How much a bond can be stretched: its length over its rest length. Beyond this value a bond
  // near a grip tears; beyond twice this value a bond in a strand that cuts have left tears
  // (elastic/tearing.cpp). 1 or more; infinity: bonds never tear. Liver has an ultimate true strain
  // of 0.38, and exp(0.38) = 1.46.
  double tearStretch = 1.46;

  bool operator==(const TissueMaterial&) const = default;

  template <class Visitor>
  void visit(Visitor& v) {
    v("name", name), v("young", young), v("poisson", poisson), v("density", density);
    v("tearStretch", tearStretch);
  }

  double shear() const { return young / (2 * (1 + poisson)); }  // mu, Pa
  // lambda, Pa.
  double lame() const { return young * poisson / ((1 + poisson) * (1 - 2 * poisson)); }
  double waveSpeed() const;  // of pressure waves in undeformed tissue, m/s
};

// The materials of docs/methods/tissue.md, all with nu = 0.45. That page gives liver by its Young's
// modulus, 5 kPa, and the others by their shear modulus.
TissueMaterial liverTissue();
TissueMaterial tumourTissue();
TissueMaterial vesselWallTissue();
TissueMaterial capsuleTissue();

// Input of elastic tissue: which cells of a cubic lattice are solid, and of which material.
struct TissueCells {
  Lattice lattice;                        // cubic
  std::vector<std::uint8_t> solid;        // per cell: 1 where there is tissue
  std::vector<TissueMaterial> materials;  // at least one
  std::vector<std::uint8_t> material;     // per cell: index into materials; empty: 0 for all
};

}  // namespace resect
