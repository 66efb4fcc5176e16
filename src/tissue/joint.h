// Joints: damped springs that hold two organs together. Each joint leads from a cell of one organ
// to a cell of another organ.
//
// A joint exerts no elastic force as long as the vector between its two cells, in world
// coordinates, is the same as at rest. So a joint resists sliding of the two organs along each
// other as well as a gap between them. In every substep the forces on the two cells are equal and
// opposite.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sph/lattice.h"
#include "tissue/tissue_model.h"

namespace resect {

struct TissueJoint {
  std::array<std::int32_t, 2> organ{};  // numbers of its two organs, which differ
  std::array<std::int64_t, 2> cell{};   // index of each cell in the lattice of its organ
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
  std::int32_t number = 0;  // number of the organ in the simulation
  const Lattice* lattice = nullptr;
  TissueModel* tissue = nullptr;
};

// Makes a joint from each solid cell of `a` to the nearest solid cell of `b`, if the distance
// between the two at rest is at most `reach`, m. stiffness: stiffness of all these joints together,
// N/m. Each joint gets an equal share of this stiffness, with two exceptions. If the share would be
// unstable in a substep of `shortest` s, the joint gets a smaller stiffness. If neither of its
// cells can move, its stiffness is 0.
std::vector<TissueJoint> joinNear(const JoinedOrgan& a, const JoinedOrgan& b, double reach,
                                  double stiffness, double shortest);

// Applies the joints' forces for the coming substep. organs: entry i is the organ with number i.
void pullJoints(std::span<const TissueJoint> joints, std::span<const JoinedOrgan> organs);

}  // namespace resect
