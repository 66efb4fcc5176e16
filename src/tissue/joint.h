// Joints: damped springs that hold two organs together. Each leads from a cell of one organ to a
// cell of another.
//
// A spring is without force when the vector between its two cells, in world axes, is the same as at
// rest. So joined organs behave as if glued at points, not hinged. Equal and opposite forces act on
// both ends at every substep.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sph/lattice.h"
#include "tissue/tissue_model.h"

namespace resect {

struct TissueJoint {
  std::array<std::int32_t, 2> organ{};  // organ numbers, different
  std::array<std::int64_t, 2> cell{};   // in the organs' lattices
  Vec3 rest = Vec3::Zero();             // from the first cell to the second at rest, m
  double stiffness = 0;                 // N/m
  double damping = 0;                   // N s/m

  template <class Visitor>
  void visit(Visitor& v) {
    v("organ", organ), v("cell", cell), v("rest", rest);
    v("stiffness", stiffness), v("damping", damping);
  }
};

struct JoinedOrgan {
  std::int32_t number = 0;
  const Lattice* lattice = nullptr;
  TissueModel* tissue = nullptr;
};

// Makes a spring from each solid cell of `a` to the nearest solid cell of `b`, if their distance at
// rest is at most `reach`, m. stiffness: of all springs together, N/m. Each spring has an equal
// share of it, or less where that would be unstable with a substep of `shortest` s.
std::vector<TissueJoint> joinNear(const JoinedOrgan& a, const JoinedOrgan& b, double reach,
                                  double stiffness, double shortest);

// Applies the joints' forces for the coming substep. organs: by organ number.
void pullJoints(std::span<const TissueJoint> joints, std::span<const JoinedOrgan> organs);

}  // namespace resect
