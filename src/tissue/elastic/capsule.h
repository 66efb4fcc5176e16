// The organ's capsule: a thin membrane on its skin, much stiffer than the tissue under it.
//
// The cells that carry the skin have the membrane's energy besides their own. It depends on the
// stretches lambda_1 and lambda_2 of the skin in its plane, which follow from the cell's
// deformation gradient. With d_i = lambda_i - 1, d_1 >= d_2, a membrane of modulus E, thickness t
// and Poisson's ratio 0.5 has the tensions (per width at rest)
//
//     T_1 = max(0, E t d_1, E t (d_1 + d_2 / 2) 4/3)      T_2 = max(0, E t (d_2 + d_1 / 2) 4/3)
//
// Where it would be compressed it wrinkles and bears nothing (tension field). Cuts separate the
// membrane with the tissue, since the gradient of a cell sees bonded neighbours only.
#pragma once

#include <span>

#include "tissue/elastic/elastic_state.h"
#include "tissue/elastic/kernel/elastic_kernel.h"
#include "tissue/tissue_model.h"

namespace resect {

// Gives the cells their part of the skin: normal and area of their patches; as a tensor, so that
// both faces of a thin margin count (ascending by cell). Skin on cells that have all 26 bonds is
// left out. Does nothing if no material has a capsule.
void setSkin(ElasticState& state, std::span<const SurfacePatch> patches);

// Updates ElasticState::capsule of the cells from their materials, bonds and tears.
void remakeCapsule(ElasticState& state, std::span<const std::int32_t> cells);

// What the capsule of a cell does at a deformation gradient F.
struct CapsuleResponse {
  double tension = 0;          // the larger one, N/m
  double energy = 0;           // J
  Mat3 stress = Mat3::Zero();  // second Piola-Kirchhoff stress times volume, J
};
CapsuleResponse capsuleResponse(const ElasticState& state, std::int32_t cell, const Mat3& f);

// Tears the capsule of the cells where its tension is beyond its strength. To be called once a
// frame.
void tearCapsule(ElasticState& state, const ElasticKernel& kernel);

}  // namespace resect
