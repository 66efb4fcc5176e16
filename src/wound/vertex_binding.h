// Bindings: the particles (cells of tissue) that a vertex near a wound follows, with their weights.
//
// A lattice cube has the centres of eight neighbouring cells as its corners. A vertex near a wound
// follows particles at the corners of the lattice cube that contains the vertex. (Vertices far from
// wounds: organ/skin/bind_vertex.h.) Beside a cut, the vertex must follow only the particles on its
// own side of the cut. The anchors of a vertex are grid nodes in the same piece of tissue as the
// vertex. To find the particles, a search starts at the anchors. The search stays in the lattice
// cube, and goes along grid edges that lie in tissue and are whole (not severed). If the search
// reaches no particle, it is extended beyond the cube. A vertex at the front of a cut, the line
// where the cut ends in tissue, has anchors on both sides of the cut. So it follows particles on
// both sides.
#pragma once

#include <span>

#include "base/index_box.h"
#include "sph/lattice.h"
#include "wound/cut_grid.h"

namespace resect {

// The present position of a vertex with rest position X is a sum over the cells of its binding: the
// sum of weight * (x_cell + F (X - X_cell)). x_cell is the present position of a cell, F its
// deformation gradient, and X_cell its rest position. The weights add up to 1.
struct VertexBinding {
  static constexpr int kMost = 8;
  std::int32_t count = 0;
  std::array<std::int32_t, kMost> cell{};  // lattice index of a particle
  std::array<float, kMost> weight{};
};

// Binds vertices that lie in a window of the grid (wound/cut_grid.h). Vertex positions are given in
// node spacings from the window's first node.
class VertexBinder {
 public:
  // grid: the window. refine: nodes per cell. particles: per lattice cell, 1 where there is a
  // particle.
  VertexBinder(const CutGrid& grid, const Lattice& lattice, int refine,
               std::span<const std::uint8_t> particles);

  // Binds the vertex at p. anchors: the vertex's anchors, relative to the node `place` of the
  // window. Particles are searched for in three ways, one after the other, until a particle is
  // found:
  // 1. over whole edges, within the lattice cube that contains p;
  // 2. over whole edges, within the window;
  // 3. without regard to cuts, up to two cells away from p along each axis.
  // If no particle is found, `count` of the result is 0. The window must be a brick with its halo
  // (BrickWindow).
  VertexBinding bind(const Vec3& p, const Vec3i& place, NearbyNodes anchors);
  // As bind(), but searches only in the first way. Any window that contains the cube may be used.
  VertexBinding bindWithin(const Vec3& p, const Vec3i& place, NearbyNodes anchors);
  // Whether any search so far went beyond the lattice cube of its vertex.
  bool lookedFar() const { return lookedFar_; }

 private:
  struct Cube;
  const Cube& cubeOf(const Vec3& p);
  Vec3i cubeAt(const Vec3i& node) const;
  VertexBinding bindWidely(const Vec3& p, const Vec3i& place, NearbyNodes anchors) const;
  VertexBinding bindToNearest(const Vec3& p) const;
  struct CubeEdges;
  CubeEdges edgesOf(const Vec3i& low) const;
  void findParts(const CubeEdges& edges, Cube& made) const;
  // The particle at a node of the window, as its lattice index; -1 if there is none.
  std::int64_t particleAt(const Vec3i& node) const;
  std::int64_t particleOf(const Vec3i& cell) const;
  // The weight of a particle is a product of three factors, one per axis. weightAlong() gives the
  // factor of one axis. p, node: coordinates of vertex and particle on this axis.
  double weightAlong(double p, int node) const;
  static void add(VertexBinding& binding, double weight, std::int64_t cell);
  // For each corner c (0 to 7) of the cube, adds the particle at this corner if counts(c) is true.
  // The binding must be empty.
  template <typename Counts>
  void addCorners(VertexBinding& binding, const Cube& cube, const Vec3& p,
                  const Counts& counts) const;

  struct Cube {
    Vec3i low;                                 // lowest node, as a node of the window
    std::array<std::uint8_t, 125> part;        // per node: its connected component, or kOutside
    std::array<std::int64_t, 8> particle;      // per corner: its lattice index, or -1
    std::array<std::uint8_t, 8> partOfCorner;  // per corner: value of `part` for its node
  };
  // Number for nodes in no component. The numbers of components are lower, since a cube has at most
  // 125 nodes.
  static constexpr std::uint8_t kOutside = 127;

  const CutGrid& grid_;
  const Lattice& lattice_;
  int refine_;
  std::span<const std::uint8_t> particles_;
  IndexBox cubesInWindow_;  // the cell at a cube's lowest corner identifies the cube
  std::vector<std::int32_t> numberOfCube_;  // index in cubes_; -1: not made yet
  std::vector<Cube> cubes_;
  bool lookedFar_ = false;
};

}  // namespace resect
