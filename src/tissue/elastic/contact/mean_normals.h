// The normal of tissue's surface, as a mean over several cells.
//
// A tip that is narrower than a cell makes a dent that the lattice does not resolve: the surface
// under it is as steep as the surface of a much wider dent, and it turns further the deeper the tip
// goes. The mean over the cells around, by area, depends on the dent's rim alone.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "tissue/elastic/contact/points.h"
#include "tissue/elastic/gradient.h"

namespace resect {

// Sums of area vectors, m^2: of the surface that faced +x, -x, +y, -y, +z, -z at rest. Surfaces
// that faced apart, as both sides of a thin sheet or the lips of a cut, are kept apart.
using AreaBySide = std::array<Vec3f, 6>;

// Mean normal, unit, outwards, at a point whose normal at rest is `normal`.
Vec3 meanNormal(const AreaBySide& around, const Vec3f& normal);

class MeanNormals {
 public:
  // Forgets all cells; to be called when the state has changed.
  void clear(const ElasticState& state);
  // Of the surface as it is now, over three cells in each direction from that one.
  AreaBySide around(const ElasticState& state, const ContactPoints& points,
                    ChunkGradients& gradients, std::int32_t cell);

 private:
  static constexpr std::int32_t kNotSeen = -1, kNoSurface = -2;
  std::int32_t find(const ElasticState& state, const ContactPoints& points,
                    ChunkGradients& gradients, std::int32_t cell);

  std::vector<std::int32_t> index_;  // per cell of the box: index in sides_, or one of the above
  std::vector<std::int32_t> seen_;   // cells whose index_ is not kNotSeen
  std::vector<AreaBySide> sides_;
  std::vector<ContactPoint> found_;  // memory that is used again
};

}  // namespace resect
