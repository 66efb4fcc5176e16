#include "isosurface/brick_mesher.h"

#include <array>
#include <cstring>

#include "base/instruction_set.h"
#include "isosurface/vertex_fours.h"

namespace resect {
namespace {

// A brick's own nodes, then the first planes of its upper neighbours along x, y and z: all that its
// vertices depend on.
constexpr int kPlane = kBrickNodes * kBrickNodes;
using NodesAbove = std::array<float, kBrickSize + 3 * kPlane>;

// For each edge of a brick, by number: the index of its upper node in that array. The lower node's
// is the last six bits of the edge's number.
constexpr std::array<std::uint8_t, kBrickEdges + 1> kUpperEnd = [] {
  std::array<std::uint8_t, kBrickEdges + 1> place{};
  for (int edge = 0; edge < kBrickEdges; ++edge) {
    const int node = edge % kBrickSize, axis = edge / kBrickSize,
              n[3] = {node & 3, node >> 2 & 3, node >> 4};
    // In a plane the other two axes keep their order.
    const int inPlane = axis == 0 ? 4 * n[2] + n[1] : axis == 1 ? 4 * n[2] + n[0] : 4 * n[1] + n[0];
    place[std::size_t(edge)] = std::uint8_t(
        n[axis] + 1 < kBrickNodes ? node + (1 << 2 * axis) : kBrickSize + axis * kPlane + inPlane);
  }
  return place;
}();

[[gnu::always_inline]] inline void gather(const ColourField& field, std::int64_t brick,
                                          const Vec3i& place, NodesAbove& nodes) {
  // At the end of the grid no edge is crossed; any brick may be read instead.
  const auto neighbour = [&](int axis, std::int64_t away) {
    return field.nodes(place[axis] + 1 < field.brickDims()[axis] ? brick + away : brick);
  };
  const std::int64_t alongY = field.brickDims().x(), alongZ = alongY * field.brickDims().y();
  std::memcpy(nodes.data(), field.nodes(brick), kBrickSize * sizeof(float));
  const float *x = neighbour(0, 1), *y = neighbour(1, alongY), *z = neighbour(2, alongZ);
  float* plane = nodes.data() + kBrickSize;
  for (int i = 0; i < kPlane; ++i) plane[i] = x[kBrickNodes * i];
  plane += kPlane;
  for (int i = 0; i < kBrickNodes; ++i)
    std::memcpy(plane + kBrickNodes * i, y + kPlane * i, kBrickNodes * sizeof(float));
  std::memcpy(plane + kPlane, z, kPlane * sizeof(float));
}

typedef std::int32_t FourInts __attribute__((vector_size(16)));
typedef double FourDoubles __attribute__((vector_size(32)));

// Selects from four numbers by the last two bits of each element of `which`.
[[gnu::always_inline]] inline FourFloats chosen(const FourFloats& numbers, const FourInts& which) {
#ifdef __clang__
  return FourFloats{numbers[which[0] & 3], numbers[which[1] & 3], numbers[which[2] & 3],
                    numbers[which[3] & 3]};
#else
  return __builtin_shuffle(numbers, which);
#endif
}

// The coordinates of a brick's four nodes along each axis, m.
using BrickPlaces = std::array<FourFloats, 3>;

[[gnu::always_inline]] inline BrickPlaces placesOf(const ColourField& field, const NodeGrid& grid,
                                                   const Vec3i& brick) {
  BrickPlaces places;
  for (int k = 0; k < 3; ++k) {
    const FourDoubles node{0, 1, 2, 3};
    places[std::size_t(k)] = __builtin_convertvector(
        field.nodePlace(k, kBrickNodes * brick[k]) + node * grid.step[k], FourFloats);
  }
  return places;
}

}  // namespace

RESECT_WIDEST
void brickVertices(const ColourField& field, const NodeGrid& grid, std::int64_t brick,
                   const BrickSigns& signs, Vec3f* points, std::uint8_t* edges) {
  const Vec3i place = field.brick(brick);
  NodesAbove nodes;
  gather(field, brick, place, nodes);
  const CrossedEdges crossed(signs);
  const BrickPlaces places = placesOf(field, grid, place);
  const auto four = [&nodes](auto at) __attribute__((always_inline)) {
    return FourFloats{nodes[at(0)], nodes[at(1)], nodes[at(2)], nodes[at(3)]};
  };
  for (int i = 0; i < signs.vertexCount(); i += 4) {
    const std::uint8_t* edge = crossed.number.data() + i;
    const FourFloats lower = four([edge](int k) { return std::size_t(edge[k] % kBrickSize); }),
                     upper = four([edge](int k) { return std::size_t(kUpperEnd[edge[k]]); }),
                     way = wayAlong(lower, upper, grid.iso, kEndMargin);
    typedef std::uint8_t FourBytes __attribute__((vector_size(4)));
    FourBytes bytes;
    std::memcpy(&bytes, edge, sizeof bytes);
    const FourInts number = __builtin_convertvector(bytes, FourInts), axis = number >> 6;
    FourFloats at[3];
    for (int k = 0; k < 3; ++k) {
      const FourFloats along = way * grid.spacing[k];
      at[k] = chosen(places[std::size_t(k)], number >> 2 * k) + (axis == k ? along : FourFloats{});
    }
    storePoints(at[0], at[1], at[2], points + i);
  }
  for (int i = 0; i < signs.vertexCount(); i += CrossedEdges::kStep)
    std::memcpy(edges + i, crossed.number.data() + i, CrossedEdges::kStep);
}

}  // namespace resect
