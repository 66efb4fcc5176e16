// SPH interpolation of any attribute at any point, from particles anywhere in space.
//
// The SPH sums of the thesis (equations 3.2 to 3.6). A query costs the particles within 2.5 h,
// found in a uniform grid of that cell size that is built once in O(n). Organs on a lattice use the
// much faster sph/colour_field.h; this is the general form and the reference in its tests. Source:
// Gingold and Monaghan 1977; Muller, Charypar and Gross 2003.
#pragma once

#include <span>
#include <vector>

#include "base/vec.h"
#include "geometry/aabb.h"

namespace resect {

class ParticleSums {
 public:
  // positions: n points, m. volumes: n values m_j / rho_j > 0, m^3. h > 0, m. Both are copied.
  ParticleSums(std::span<const Vec3> positions, std::span<const double> volumes, double h);

  // Equation 3.2: sum over j of V_j A_j W(r - r_j, h); `attribute` has one value per particle.
  double interpolate(std::span<const double> attribute, const Vec3& r) const;
  // Equation 3.4: sum over j of V_j W(r - r_j, h), about 1 inside a body, 0 outside ("Shepard
  // sum").
  double partitionOfUnity(const Vec3& r) const;
  // Equation 3.5: sum over j of m_j W(r - r_j, h), kg/m^3; `mass` in kg.
  double density(std::span<const double> mass, const Vec3& r) const;
  // Equation 3.6: the colour field, interpolate() with attribute 1; the same number as
  // partitionOfUnity().
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
