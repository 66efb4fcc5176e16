// What holds tissue together that is one cell thin?
//
// A cell of a sheet or a string of single cells has no deformation gradient, and a bond between two
// such cells has no energy. It is given one as a fibre: a spring along the bond, of about the
// tissue's own stiffness, E s / 2 for a face neighbour and less further off. Turns with the tissue,
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
  float length = 0;            // at which it does not pull, m

  template <class Visitor>
  void visit(Visitor& v) {
    v("a", a), v("b", b), v("stiffness", stiffness), v("rest", rest), v("length", length);
  }
};

// Share of E s that a fibre has, by kind of neighbour.
inline constexpr float kFibreShare[4] = {0, 0.5f, 0.25f, 0.15f};

// All bonds of which neither end has a gradient, in ascending order. Those among `before` stay as
// they are; a new one does not pull at the length that it has now, so that a cut that makes fibres
// of stretched tissue adds no energy.
std::vector<Fibre> findFibres(const ElasticState& state, std::span<const Fibre> before);

// Adds their forces to the bond forces of the stress pass.
void pullFibres(std::span<const Fibre> fibres, ElasticState& state);

double fibreEnergy(std::span<const Fibre> fibres, const ElasticState& state);  // J

}  // namespace resect
