// SPH interpolation of any attribute at any point, from particles anywhere in space.
//
// These are the SPH sums at a point r, equations 3.2 to 3.6 of the diploma thesis that Resect
// continues. A_j, V_j, m_j and r_j are the attribute, volume, mass and position of particle j; W
// and h are the kernel and its smoothing length (sph/kernel.h). The particles are sorted into a
// uniform grid once, in O(number of particles). A query visits only the particles in the grid's
// cells near r. The grid's cells are at least as wide as the kernel's radius, 2.5 h.
//
// Organs on a lattice use the much faster sph/colour_field.h. The sums here are more general. The
// tests of the colour field compare the field with these sums. Sources: Gingold and Monaghan 1977;
// Muller, Charypar and Gross 2003.
#pragma once

#include <span>
#include <vector>

#include "base/vec.h"
#include "geometry/aabb.h"

namespace resect {

class ParticleSums {
 public:
  // positions: one point per particle, m. volumes: per particle, its mass divided by its density,
  // V_j > 0, m^3. h > 0, m. Positions and volumes are copied.
  ParticleSums(std::span<const Vec3> positions, std::span<const double> volumes, double h);

  // Equation 3.2: sum over j of V_j A_j W(r - r_j, h); `attribute` has one value per particle.
  double interpolate(std::span<const double> attribute, const Vec3& r) const;
  // Equation 3.4, the Shepard sum: sum over j of V_j W(r - r_j, h). It is about 1 inside a body and
  // 0 outside.
  double partitionOfUnity(const Vec3& r) const;
  // Equation 3.5: sum over j of m_j W(r - r_j, h), kg/m^3; `mass` in kg.
  double density(std::span<const double> mass, const Vec3& r) const;
  // Equation 3.6, the colour field: interpolate() with the attribute 1 for all particles. This is
  // the same as partitionOfUnity().
  double colour(const Vec3& r) const { return partitionOfUnity(r); }

 private:
  template <typename Visit>
  void visitNeighbours(const Vec3& r, Visit visit) const;

  double h_;
  Aabb box_;
  Vec3i dims_;
  // Per cell: index of its first sorted particle. The last element is the number of particles.
  std::vector<std::int32_t> cellStart_;
  std::vector<std::int32_t> index_;  // per sorted particle: its number in the constructor
  std::vector<Vec3> position_;       // sorted by cell; volume_ is sorted in the same way
  std::vector<double> volume_;
};

}  // namespace resect
