// Bindings: the particles that a vertex near a wound follows, with their weights.
//
// Far from wounds a vertex follows the particles at the corners of the lattice cube that it lies
// in. Beside a cut it must follow only the particles on its own side. These are the cube's
// particles that are connected to the vertex's anchors, within the cube, over whole grid edges
// through tissue. If no particle is found so, the search is widened. A vertex at the front of a cut
// has anchors on both sides and follows both.
#pragma once

#include <span>

#include "base/index_box.h"
#include "sph/lattice.h"
#include "wound/cut_grid.h"

namespace resect {

// The present position of a vertex with rest position X is the weighted sum over the cells of
// x_cell + F (X - X_cell). x_cell, F and X_cell are the cell's present position, deformation
// gradient and rest position. The weights add up to 1.
struct VertexBinding {
  static constexpr int kMost = 8;
  std::int32_t count = 0;
  std::array<std::int32_t, kMost> cell{};  // lattice index of a particle
  std::array<float, kMost> weight{};
};

// Binds the vertices that lie in a window of the grid.
class VertexBinder {
 public:
  // particles: per lattice cell, 1 where there is a particle.
  VertexBinder(const CutGrid& grid, const Lattice& lattice, int refine,
               std::span<const std::uint8_t> particles);

  // p: position in the window. anchors: relative to `place`, a node of the window. Searches first
  // the lattice cube that contains p, then the window over whole edges, then the cells up to two
  // away along each axis, even across a cut. If no particle is found, count is 0. The window must
  // be that of a brick.
  VertexBinding bind(const Vec3& p, const Vec3i& place, NearbyNodes anchors);
  // The same, but searches only the lattice cube that contains p. The window may be any that holds
  // the cube.
  VertexBinding bindWithin(const Vec3& p, const Vec3i& place, NearbyNodes anchors);
  // Whether any search so far went beyond the vertex's lattice cube.
  bool lookedFar() const { return lookedFar_; }
  // Binds to all particles of the lattice cube that contains p.
  VertexBinding bindAll(const Vec3& p);

 private:
  struct Cube;
  const Cube& cubeOf(const Vec3& p);
  Vec3i cubeAt(const Vec3i& node) const;
  VertexBinding bindWidely(const Vec3& p, const Vec3i& place, NearbyNodes anchors) const;
  VertexBinding bindToNearest(const Vec3& p) const;
  struct CubeEdges;
  CubeEdges edgesOf(const Vec3i& low) const;
  void findParts(const CubeEdges& edges, Cube& made) const;
  // The lattice cell at a node of the window, or -1 where there is no particle.
  std::int64_t particleAt(const Vec3i& node) const;
  std::int64_t particleOf(const Vec3i& cell) const;
  // Factor of a particle's weight for one axis. p, node: coordinates of vertex and particle on that
  // axis.
  double weightAlong(double p, int node) const;
  static void add(VertexBinding& binding, double weight, std::int64_t cell);
  // Adds the particle at each corner c of the cube for which counts(c) is true. The binding must be
  // empty.
  template <typename Counts>
  void addCorners(VertexBinding& binding, const Cube& cube, const Vec3& p,
                  const Counts& counts) const;

  struct Cube {
    Vec3i low;
    std::array<std::uint8_t, 125> part;    // per node: its connected component, or kOutside
    std::array<std::int64_t, 8> particle;  // per corner: lattice index, or -1
    std::array<std::uint8_t, 8> partOfCorner;
  };
  static constexpr std::uint8_t kOutside = 127;  // no component: a cube has at most 125 nodes

  const CutGrid& grid_;
  const Lattice& lattice_;
  int refine_;
  std::span<const std::uint8_t> particles_;
  IndexBox cubesInWindow_;  // a cube is given by the lattice cell at its lowest corner
  std::vector<std::int32_t> numberOfCube_;
  std::vector<Cube> cubes_;
  bool lookedFar_ = false;
};

}  // namespace resect
