// Fibres: springs along bonds of tissue that is only one cell thick.
//
// A cell of a sheet or a string of single cells has no deformation gradient. A bond between two
// such cells has no energy, so it gets a fibre. This is a spring along the bond of about the
// tissue's stiffness: E s / 2 between face neighbours and less between others, with Young's modulus
// E and the spacing s. A fibre rotates with the tissue and does not resist bending.
#pragma once

#include <span>
#include <vector>

#include "tissue/elastic/elastic_state.h"

namespace resect {

struct Fibre {
  std::int32_t a = 0, b = 0;   // cells of the box
  float stiffness = 0;         // N/m
  Vec3f rest = Vec3f::Zero();  // from a to b at rest, m
  float length = 0;            // rest length, m

  template <class Visitor>
  void visit(Visitor& v) {
    v("a", a), v("b", b), v("stiffness", stiffness), v("rest", rest), v("length", length);
  }
};

// Stiffness of a fibre as a fraction of E s, by kind of neighbour (tissue/stencil.h).
inline constexpr float kFibreShare[4] = {0, 0.5f, 0.25f, 0.15f};

// The fibres of all bonds of which neither end has a gradient, in ascending order of a, then b. A
// bond that has a fibre in `before` keeps it. A new fibre's rest length is the bond's present
// length, so that a cut through stretched tissue adds no energy.
std::vector<Fibre> findFibres(const ElasticState& state, std::span<const Fibre> before);

// Adds the fibres' forces to the bond forces of the stress pass.
void pullFibres(std::span<const Fibre> fibres, ElasticState& state);

double fibreEnergy(std::span<const Fibre> fibres, const ElasticState& state);  // J

}  // namespace resect
