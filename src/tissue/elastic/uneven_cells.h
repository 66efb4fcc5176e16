// Cells beside which the tissue is different: at a joint of two materials, and beside a cell
// without a deformation gradient (docs/methods/tissue.md, "Joints of materials").
//
// A bond connects two neighbouring cells. It is uneven if the cells have different penalty
// stiffnesses kappa; that of a cell without a gradient is 0. The stress pass computes the force on
// a cell with the cell's own kappa for all of its bonds, so that one sum is enough. The forces in
// the few uneven bonds are corrected afterwards.
#pragma once

#include <span>
#include <vector>

#include "tissue/elastic/elastic_state.h"

namespace resect {

// What changes for a cell that is bonded to cells of other materials.
struct MaterialJoint {
  // The gradient of such a cell is a mean over both materials. Multiplied from the right by the
  // square of this symmetric matrix, it is that of the cell's own material. I away from joints.
  Mat3 toOwn = Mat3::Identity();
  // Modulus for the penalty, Pa: of springs in series over the cell and its bonded neighbours.
  double shear = 0;
};
MaterialJoint jointAt(const ElasticState& state, std::int32_t cell);

struct UnevenBond {
  std::int32_t a, b;  // its two cells: indices in ElasticState::box
  // w (kappa_b - kappa_a) / spacing^2, N/m. w: weight of the bond, from bondWeights().
  float stiffness;
};

// All uneven bonds, in ascending order of a. Cost: some ns per cell of the chunks that are marked
// as uneven (TissueChunk::uneven).
std::vector<UnevenBond> findUnevenBonds(const ElasticState& state);

// Adds the corrections to ElasticState::bondForce. Call after the stress pass.
void pullUnevenBonds(std::span<const UnevenBond> bonds, ElasticState& state);

}  // namespace resect
