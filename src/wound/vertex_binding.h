// Bindings: the particles that a vertex near a wound follows, with their weights.
//
// Far from wounds a vertex follows the particles at the corners of the lattice cube that it lies
// in. Beside a cut it must follow only those on its own side: the cube's particles that are
// connected, within the cube and over whole grid edges through tissue, to the vertex's anchors
// (nodes of its piece of tissue). If that finds no particle, the search is widened. A vertex at the
// front of a cut has anchors on both sides and follows both.
#pragma once

#include <span>

#include "base/index_box.h"
#include "sph/lattice.h"
#include "wound/cut_grid.h"

namespace resect {

// Present position = sum of weight (x + F (X - X_cell)) over the cells; weights add up to 1.
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

  // p: in the window; anchors: relative to `place`, a node of the window. Cells of equal weight are
  // in lattice order. Without a particle within two cells count is 0. The window must be a brick's.
  VertexBinding bind(const Vec3& p, const Vec3i& place, NearbyNodes anchors);
  // The same without searching beyond the lattice cube that contains p, in any window that holds
  // the cube: count is 0 if that finds nothing.
  VertexBinding bindWithin(const Vec3& p, const Vec3i& place, NearbyNodes anchors);
  // Whether any search so far went beyond its cube.
  bool lookedFar() const { return lookedFar_; }
  // All particles of the lattice cube that p lies in.
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
  // Factor of a particle's weight along one axis, p and node being coordinates on it.
  double weightAlong(double p, int node) const;
  static void add(VertexBinding& binding, double weight, std::int64_t cell);
  // Adds the cube's particles for whose corner c counts(c) is true; the binding must be empty.
  template <typename Counts>
  void addCorners(VertexBinding& binding, const Cube& cube, const Vec3& p,
                  const Counts& counts) const;

  struct Cube {
    Vec3i low;
    std::array<std::uint8_t, 125> part;    // per node: its connected component, or kOutside
    std::array<std::int64_t, 8> particle;  // per corner
    std::array<std::uint8_t, 8> partOfCorner;
  };
  static constexpr std::uint8_t kOutside = 127;  // more than a cube's nodes

  const CutGrid& grid_;
  const Lattice& lattice_;
  int refine_;
  std::span<const std::uint8_t> particles_;
  IndexBox cubesInWindow_;  // by the lattice cell at their lowest corner
  std::vector<std::int32_t> numberOfCube_;
  std::vector<Cube> cubes_;
  bool lookedFar_ = false;
};

}  // namespace resect
