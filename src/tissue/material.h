// Materials of tissue: stiffness, stiffening, relaxation, density, toughness.
//
// Under a lasting load the material is a solid with this elastic energy per volume at rest:
//
//     Psi(F) = mu/2 (x + b/2 x^2) + (lambda + mu)/2 (J - 1)^2,     x = F:F - 3 - 2 (J - 1)
//
// F is the deformation gradient and J its determinant. lambda and mu are Lame's constants. b is the
// stiffening. x is 0 at rest, and gamma^2 in a simple shear by gamma. So the shear modulus grows as
// 1 + b gamma^2. Where x is below 0, b is replaced by 0. Without stiffening (b = 0) this is a
// neo-Hookean solid whose energy stays finite when a cell is inverted. It is the material of Smith,
// de Goes and Kim 2018, without their barrier term. At small strain the solid has Young's modulus E
// and Poisson's ratio nu.
//
// Each Maxwell branch adds a deviatoric stress, which decays with the branch's relaxation time. At
// time t after a small sudden strain, the shear modulus is mu (1 + sum over the branches of share
// exp(-t / time)), a Prony series. Defaults and their sources: docs/methods/tissue.md.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sph/lattice.h"

namespace resect {

inline constexpr int kMostBranches = 3;

// A Maxwell branch.
struct Relaxation {
  double share = 0;  // modulus of the branch divided by mu, 0 to 10
  double time = 1;   // relaxation time, s, 0.005 to 1000

  bool operator==(const Relaxation&) const = default;
  template <class Visitor>
  void visit(Visitor& v) {
    v("share", share), v("time", time);
  }
};

struct TissueMaterial {
  std::string name = "liver";
  double young = 5000;               // Young's modulus under a lasting load, Pa, 1 to 1e9
  double poisson = 0.45;             // 0 to 0.4999; near 0.5 waves are fast, so substeps are short
  double density = 1060;             // kg/m^3, 1 to 1e5
  double stiffening = 0;             // b, 0 to 20
  std::vector<Relaxation> branches;  // at most kMostBranches
  // capsule: Young's modulus times thickness of the capsule, the membrane on an organ of this
  // material, N/m, 0 to 1e5; 0: there is no capsule. capsuleStrength: tension beyond which the
  // capsule tears, N/m.
  double capsule = 0;
  double capsuleStrength = 300;
  // Tension of the capsule of the intact organ, in all directions along the surface, N/m, 0 to 1e4.
  // It shows where the capsule is cut: the edges of the cut draw back.
  double capsuleTension = 0;
  // G: energy per area that a tear needs, J/m^2, above 0. If it is infinite, the material never
  // tears. For liver, Gokgol et al. 2012 measured 164 +- 6 with needles.
  double tearEnergy = 164;
  // cutEnergy: energy per area that a cut by a sharp edge takes, J/m^2. capsuleCutEnergy: energy
  // that the cut takes in addition per length of capsule that is cut, J/m. If both are 0, the edge
  // meets no resistance.
  double cutEnergy = 0;
  double capsuleCutEnergy = 0;

  bool operator==(const TissueMaterial&) const = default;

  template <class Visitor>
  void visit(Visitor& v) {
    v("name", name), v("young", young), v("poisson", poisson), v("density", density);
    v("tearEnergy", tearEnergy), v("stiffening", stiffening), v("branches", branches);
    v("capsule", capsule), v("capsuleStrength", capsuleStrength);
    v("capsuleTension", capsuleTension);
    v("cutEnergy", cutEnergy), v("capsuleCutEnergy", capsuleCutEnergy);
  }

  double shear() const { return young / (2 * (1 + poisson)); }  // mu, Pa
  // lambda, Pa.
  double lame() const { return young * poisson / ((1 + poisson) * (1 - 2 * poisson)); }
  double viscousShear() const;  // sum of the branches' moduli, Pa: added to mu at a sudden load
  double waveSpeed() const;     // speed of pressure waves in undeformed tissue, m/s
};

// Tissue without a crack tears where its elastic energy per volume exceeds the tear energy divided
// by this length, m (docs/methods/tissue.md, "Tearing").
inline constexpr double kTearLength = 0.01;

// Psi(F), J/m^3, without the Maxwell branches. The growth b x of the shear modulus is limited to
// kMostStiffening (tissue/elastic/kernel/elastic_kernel.h).
double heldEnergy(const TissueMaterial& material, const Mat3& f);
// The tear energy, J/m^2, that belongs to a stretch: with this tear energy, a block of the material
// without a crack tears at that stretch if it is pulled slowly. stretch: length divided by length
// at rest, 1 to 100.
double energyOfStretch(const TissueMaterial& material, double stretch);

// The materials of docs/methods/tissue.md, all with nu = 0.45. That page specifies liver by its
// Young's modulus, 5 kPa, and the other materials by their shear moduli.
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
  // Share of each cell that holds tissue, from 0 to 1. Empty: 1 where a cell is solid.
  std::vector<float> share = {};
  // Per cell: 1 + d if the cell is not solid, but holds tissue that belongs to its solid neighbour
  // in direction d (tissue/stencil.h); else 0. Empty: 0 for all. Needs `share`.
  std::vector<std::uint8_t> owner = {};
};

}  // namespace resect
