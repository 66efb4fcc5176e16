// SPH interpolation of any attribute at any point, from particles anywhere in space.
//
// The SPH sums of the thesis (equations 3.2 to 3.6). A_j, V_j, m_j and r_j are the attribute,
// volume, mass and position of particle j; W and h are the kernel and its smoothing length
// (sph/kernel.h). A query visits the particles near r in a uniform grid, which is built once in
// O(n). Its cells are as wide as the kernel's radius, 2.5 h, or a little wider. Organs on a lattice
// use the much faster sph/colour_field.h; the sums here are the general form, and the reference in
// the tests of the colour field. Source: Gingold and Monaghan 1977; Muller, Charypar and Gross
// 2003.
#pragma once

#include <span>
#include <vector>

#include "base/vec.h"
#include "geometry/aabb.h"

namespace resect {

class ParticleSums {
 public:
  // positions: n points, m. volumes: n values V_j > 0, m^3, each mass over density. h > 0, m.
  // Positions and volumes are copied.
  ParticleSums(std::span<const Vec3> positions, std::span<const double> volumes, double h);

  // Equation 3.2: sum over j of V_j A_j W(r - r_j, h); `attribute` has one value per particle.
  double interpolate(std::span<const double> attribute, const Vec3& r) const;
  // Equation 3.4, the Shepard sum: sum over j of V_j W(r - r_j, h). It is about 1 inside a body and
  // 0 outside.
  double partitionOfUnity(const Vec3& r) const;
  // Equation 3.5: sum over j of m_j W(r - r_j, h), kg/m^3; `mass` in kg.
  double density(std::span<const double> mass, const Vec3& r) const;
  // Equation 3.6, the colour field: interpolate() with an attribute of 1 for all particles, which
  // is the same number as partitionOfUnity().
  double colour(const Vec3& r) const { return partitionOfUnity(r); }

 private:
  template <typename Visit>
  void visitNeighbours(const Vec3& r, Visit visit) const;

  double h_;
  Aabb box_;
  Vec3i dims_;
  std::vector<std::int32_t> cellStart_;
  std::vector<std::int32_t> index_;  // original number of each sorted particle
  std::vector<Vec3> position_;       // sorted by cell
  std::vector<double> volume_;
};

}  // namespace resect
