// The organ's capsule: a thin membrane on the organ's surface, much stiffer than the tissue below.
// "Skin" means the organ's surface as it was before any cuts.
//
// The cells at the skin have the membrane's energy in addition to their own. This energy depends on
// the principal stretches lambda_1 and lambda_2 in the plane of the skin. These stretches follow
// from the cell's deformation gradient. Let d_i = lambda_i - 1 + tightness and d_1 >= d_2. A
// membrane with Young's modulus E, thickness t and Poisson's ratio 0.5 has the tensions (force per
// width at rest)
//
//     T_1 = max(0, E t d_1, E t (d_1 + d_2 / 2) 4/3)      T_2 = max(0, E t (d_2 + d_1 / 2) 4/3)
//
// Where the membrane would be compressed, it wrinkles and bears no load (tension field). A cut
// through the tissue also separates the membrane, since the deformation gradient of a cell depends
// on bonded neighbours only.
//
// In the intact organ the membrane is under tension already (TissueMaterial::capsuleTension). This
// tension is in equilibrium with the pressure of the blood in the tissue, so the organ at rest is
// computed without either of them, with a tightness of 0. A cut ends the equilibrium: the edges of
// the cut draw back, and the wound gapes. To compute this, the membrane round a wound gets the
// tightness at which it has its tension at rest.
#pragma once

#include <span>

#include "tissue/elastic/elastic_state.h"
#include "tissue/elastic/kernel/elastic_kernel.h"
#include "tissue/tissue_model.h"

namespace resect {

// Sets the normal and the area of each cell's skin from the cell's patches, which are small pieces
// of the skin. The tensors area * n n^T of these patches are added, where n is a patch's normal.
// The skin's area is the largest eigenvalue of the sum; the skin's normal is the eigenvector of
// this eigenvalue. So in thin tissue the patches on both sides count, although their normals are
// opposite. patches: ascending by cell. A cell that is bonded to all its 26 neighbours gets no
// skin. Does nothing if no material has a capsule.
void setSkin(ElasticState& state, std::span<const SurfacePatch> patches);

// Updates ElasticState::capsule of the cells from their material, their bonds, and
// ElasticState::capsuleTorn.
void remakeCapsule(ElasticState& state, std::span<const std::int32_t> cells);

// Updates ElasticState::lips and ElasticState::tightness after a change of the bonds of these
// cells. The tightness is greatest at the lips, and falls linearly to 0 over a distance of 60 mm.
void retractCapsule(ElasticState& state, std::span<const std::int32_t> cells);

// Tension, energy and stress of the capsule of a cell with the deformation gradient f.
struct CapsuleResponse {
  double tension = 0;          // T_1, N/m
  double energy = 0;           // more than at rest, J
  Mat3 stress = Mat3::Zero();  // second Piola-Kirchhoff stress times volume, J
};
CapsuleResponse capsuleResponse(const ElasticState& state, std::int32_t cell, const Mat3& f);

// Tears the capsule of every cell in which the tension of the capsule exceeds the capsule's
// strength. Call once per frame.
void tearCapsule(ElasticState& state, const ElasticKernel& kernel);

}  // namespace resect
