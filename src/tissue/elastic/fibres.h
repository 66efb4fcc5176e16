// Fibres: springs along bonds of tissue that is one cell thin.
//
// A cell of a sheet or a string of single cells has no deformation gradient, so a bond between two
// such cells has no energy. It gets a fibre instead: a spring along the bond of about the tissue's
// stiffness, E s / 2 for a face neighbour and less for others. A fibre rotates with the tissue and
// does not resist bending.
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

// Stiffness of a fibre over E s, by kind of neighbour.
inline constexpr float kFibreShare[4] = {0, 0.5f, 0.25f, 0.15f};

// Fibres for all bonds of which neither end has a gradient, in ascending order. Fibres in `before`
// are kept; a new one has its present length as rest length, so that a cut through stretched tissue
// adds no energy.
std::vector<Fibre> findFibres(const ElasticState& state, std::span<const Fibre> before);

// Adds their forces to the bond forces of the stress pass.
void pullFibres(std::span<const Fibre> fibres, ElasticState& state);

double fibreEnergy(std::span<const Fibre> fibres, const ElasticState& state);  // J

}  // namespace resect
