// The surface of tissue that has moved: vertices of the rest surface follow the particles round
// them, without meshing again.
//
// A vertex at X in rest space follows up to eight particles round it. Its present position is
// x = sum w_i (x_i + F_i (X - X_i)), where particle i is at X_i at rest and at x_i now, and F_i is
// its deformation gradient. The weights w_i are trilinear, normalised over the particles that are
// left. Beside a wound the surface tracker's bindings name the particles on the vertex's own side
// (wound/vertex_binding.h). Normals are transformed by the cofactor of the weighted mean of F_i.
// Cost: a few products per vertex and frame, and a search for each vertex that changed.
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
  // Call after surface.update() and moveTissues() (tissue/move_tissues.h). `changedCells`:
  // particles removed since the last call. withLook: also computes normals; requires
  // surface.updateLook().
  void follow(const SurfaceTracker& surface, const Lattice& lattice, const TissueModel& tissue,
              std::span<const std::int64_t> changedCells, bool withLook);
  // Computes normals for the positions of the last follow().
  void turnNormals(const SurfaceTracker& surface);

  // One per vertex of the surface's arrays.
  std::span<const Vec3f> points() const { return points_; }    // world, m
  std::span<const Vec3f> normals() const { return normals_; }  // unit, outwards; if asked for
  std::size_t bytes() const;                                   // memory held

 private:
  struct Binding {
    std::array<std::int32_t, 8> entry{};  // into cells_
    std::array<float, 8> weight{};        // 0: this entry and those after it are unused
  };
  Binding bind(const Vec3f& vertex, const Lattice& lattice, const TissueModel& tissue);
  void findMotions(const Lattice& lattice, const TissueModel& tissue);
  ParticleMotion motionOf(const Binding& binding) const;
  void movePoints(std::span<const Vec3f> rest);
  std::int32_t entryOf(std::int64_t cell);

  std::vector<Binding> bindings_;
  std::vector<std::int64_t> cells_;        // that vertices follow
  std::vector<std::int32_t> entryOfCell_;  // per lattice cell: index into cells_, or -1
  std::vector<Vec3f> restOfCell_;
  std::vector<CellPlacement> placements_;
  std::vector<ParticleMotion> motions_;
  std::vector<Vec3f> points_, normals_;
  std::vector<std::uint8_t> changed_;  // per entry of cells_
};

}  // namespace resect
