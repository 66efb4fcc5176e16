// Where are the nodes of the grid now that the tissue has moved?
//
// A blade meets tissue where it is, not where it was at rest: before edges are severed
// (surface/blade_raster.h), the nodes of the bricks near the blade follow their particles as the
// surface's vertices do (surface/vertex_binding.h). A node outside tissue follows all particles of
// its lattice cube; one with none has no place. Cost: some 20 us
// per brick, less where few of its nodes are wanted.
#pragma once

#include <bitset>

#include "surface/blade_raster.h"
#include "surface/wound_brick.h"

namespace resect {

// How a particle has moved: its place, and how the tissue round it is stretched and turned.
struct ParticleMotion {
  Vec3 rest = Vec3::Zero();      // its place at rest, m
  Vec3 position = Vec3::Zero();  // and now: world, m
  Mat3 gradient = Mat3::Identity();
};

// Where a point at X in rest space is now that follows the binding. motionOf(cell) gives the motion
// of a particle by its lattice index.
template <typename MotionOf>
Vec3 followed(const VertexBinding& binding, const Vec3& X, const MotionOf& motionOf) {
  Vec3 x = Vec3::Zero();
  for (int i = 0; i < binding.count; ++i) {
    const ParticleMotion& motion = motionOf(std::int64_t(binding.cell[std::size_t(i)]));
    const Vec3 arm = X - motion.rest;
    x += double(binding.weight[std::size_t(i)]) * (motion.position + motion.gradient * arm);
  }
  return x;
}

// Some of a brick's 5 x 5 x 5 nodes, x fastest.
using PlacedNodes = std::bitset<kPlacedNodes>;

// What each of the `wanted` nodes of a brick follows; count 0 where nothing is near, and for
// others.
void bindNodes(const ColourField& field, const Wound& wound, float iso, const Vec3i& brick,
               const PlacedNodes& wanted, std::span<VertexBinding, kPlacedNodes> bindings);

// The places of a brick's nodes, as severAlong() asks for them; none for those not wanted.
template <typename MotionOf>
void placeNodes(const ColourField& field, const Wound& wound, float iso, const Vec3i& brick,
                const PlacedNodes& wanted, const MotionOf& motionOf,
                std::span<Vec3, kPlacedNodes> places) {
  std::array<VertexBinding, kPlacedNodes> bindings;
  bindNodes(field, wound, iso, brick, wanted, bindings);
  for (int i = 0; i < kPlacedNodes; ++i) {
    const Vec3 node = (kBrickNodes * brick + Vec3i(i % 5, i / 5 % 5, i / 25)).cast<double>();
    places[std::size_t(i)] =
        bindings[std::size_t(i)].count > 0
            ? followed(bindings[std::size_t(i)], field.nodePosition(node), motionOf)
            : Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
  }
}

}  // namespace resect
