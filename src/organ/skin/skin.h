// The surface of tissue that has moved. It is not meshed again: the vertices of the surface at rest
// follow the particles round them.
//
// A vertex with rest position X follows up to eight particles (organ/skin/bind_vertex.h). Its
// present position is x = sum w_i (x_i + F_i (X - X_i)). Here X_i is the rest position of particle
// i, x_i its present position, F_i its deformation gradient and w_i its weight. The weights add up
// to 1. For a particle with at most 13 bonds, as at a thin edge of the organ, F_i is replaced by
// the mean of F over the particle and the particles bonded to it. Beside a wound, vertices use the
// surface tracker's bindings, which hold only particles on the vertex's own side
// (wound/vertex_binding.h). Normals are transformed by the cofactor matrix of the weighted mean of
// the F_i. Cost per frame: a weighted mean of up to eight motions for each vertex. Some vertices
// also need a search for their particles: new vertices, and vertices that followed a particle that
// was removed, lost a bond or gained a bond.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sph/lattice.h"
#include "surface/surface_tracker.h"
#include "tissue/tissue_model.h"
#include "wound/particle_motion.h"

namespace resect {

class SurfaceSkin {
 public:
  // Moves the vertices. Call after surface.update() and moveTissues() (tissue/move_tissues.h).
  // changedCells: cells whose particles were removed since the last call of follow(), or came back
  // because a state was restored. withLook: whether to compute normals too; surface.updateLook()
  // must then have been called before.
  void follow(const SurfaceTracker& surface, const Lattice& lattice, const TissueModel& tissue,
              std::span<const std::int64_t> changedCells, bool withLook);
  // Computes normals for the positions that follow() computed last.
  void turnNormals(const SurfaceTracker& surface);

  // One per vertex of the surface's arrays.
  std::span<const Vec3f> points() const { return points_; }    // world, m
  std::span<const Vec3f> normals() const { return normals_; }  // unit, outwards; if computed
  std::size_t bytes() const;                                   // memory held

 private:
  struct Binding {
    std::array<std::int32_t, 8> entry{};  // indices into cells_
    std::array<float, 8> weight{};        // 0: this entry and those after it are unused
  };
  void setBinding(std::size_t vertex, const VertexBinding& followed, const TissueModel& tissue);
  bool markChanged(std::span<const std::int64_t> changedCells, const TissueModel& tissue);
  bool findDue(const SurfaceTracker& surface, std::size_t before, const Lattice& lattice,
               const TissueModel& tissue, std::span<const std::int64_t> changedCells);
  bool followsFar(const Vec3f& rest, const Binding& binding, const Lattice& lattice) const;
  void findMotions(const Lattice& lattice, const TissueModel& tissue);
  ParticleMotion motionOf(const Binding& binding) const;
  void movePoints(std::span<const Vec3f> rest);
  std::int32_t entryOf(std::int64_t cell);

  std::vector<Binding> bindings_;
  std::vector<std::int64_t> cells_;         // the particles that vertices follow
  std::vector<std::int32_t> entryOfCell_;   // per lattice cell: index into cells_, or -1
  std::vector<Vec3f> restOfCell_;           // rest positions of cells_, m
  std::vector<std::uint32_t> bondsOfCell_;  // bonds of cells_ (bit masks) at the last follow()
  std::vector<CellPlacement> placements_;
  std::vector<ParticleMotion> motions_;
  std::vector<Vec3f> points_, normals_;
  std::vector<std::uint8_t> changed_;  // per entry of cells_: 1 where its particle changed
  std::vector<std::uint8_t> due_;      // per vertex: 1 where it must be bound anew
};

}  // namespace resect
