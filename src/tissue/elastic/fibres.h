// Fibres: springs along the bonds of tissue that is only one cell thick.
//
// In a sheet or a string of single cells, cells have too few neighbours for a deformation gradient.
// So without a fibre, a bond between two of these cells would not resist stretching. A fibre is a
// spring along the bond, about as stiff as the tissue. Let E be Young's modulus and s the spacing.
// The stiffness is E s / 2 between face neighbours, and less between edge and corner neighbours. A
// fibre rotates with the tissue and does not resist bending.
#pragma once

#include <span>
#include <vector>

#include "tissue/elastic/elastic_state.h"

namespace resect {

struct Fibre {
  std::int32_t a = 0, b = 0;   // its two cells: indices in ElasticState::box
  float stiffness = 0;         // N/m
  Vec3f rest = Vec3f::Zero();  // from a to b in rest space, m
  float length = 0;            // length at which the fibre exerts no force, m

  template <class Visitor>
  void visit(Visitor& v) {
    v("a", a), v("b", b), v("stiffness", stiffness), v("rest", rest), v("length", length);
  }
};

// Stiffness of a fibre divided by E s, by kind of neighbour: see neighbourKind() in
// tissue/stencil.h.
inline constexpr float kFibreShare[4] = {0, 0.5f, 0.25f, 0.15f};

// The fibres of all bonds between two cells without a gradient, in ascending order of a, then b. A
// bond that has a fibre in `before` keeps that fibre. Any other bond gets a fibre that exerts no
// force at the bond's present length. So if a cut makes stretched tissue so thin that its bonds get
// fibres, these fibres add no energy.
std::vector<Fibre> findFibres(const ElasticState& state, std::span<const Fibre> before);

// Adds the fibres' forces to ElasticState::bondForce. Call after the stress pass.
void pullFibres(std::span<const Fibre> fibres, ElasticState& state);
// A cord (tissue/cord.h): a fibre that exerts no force when it is shorter than at rest.
struct Cord : Fibre {
  float wanted = 0;  // stiffness before it is limited for stability, N/m
};
void pullCords(std::span<const Cord> cords, ElasticState& state);

// Elastic energy of all fibres or cords, J.
double fibreEnergy(std::span<const Fibre> fibres, const ElasticState& state);
double cordEnergy(std::span<const Cord> cords, const ElasticState& state);

}  // namespace resect
