// The normal of the tissue's surface, as a mean over several cells.
//
// An instrument's tip that is narrower than a cell makes a dent that the lattice of cells does not
// resolve. The computed normals under the tip are inclined as if the dent were much wider, and
// their inclination grows as the tip goes deeper. The mean normal over the surrounding cells,
// weighted by area, does not have this error, since the sum of the area vectors of a dent depends
// on the rim of the dent alone.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "tissue/elastic/contact/points.h"
#include "tissue/elastic/gradient.h"

namespace resect {

// Six sums of present area vectors, m^2, one for each of the directions +x, -x, +y, -y, +z and -z.
// Each part of the surface contributes to the sums of the directions that it faced at rest, in
// proportion to the components of its normal at rest. So the two sides of a thin sheet, or the two
// lips of a cut, are not mixed.
using AreaBySide = std::array<Vec3f, 6>;

// Mean normal, unit, outwards, at a point whose normal at rest is `normal`. around: the sums over
// the surface round this point.
Vec3 meanNormal(const AreaBySide& around, const Vec3f& normal);

class MeanNormals {
 public:
  // Discards the sums of all cells. Call when the state has changed.
  void clear(const ElasticState& state);
  // The sums over the present surface of `cell` and of all cells that are at most three cells away
  // from it along each axis.
  AreaBySide around(const ElasticState& state, const ContactPoints& points,
                    ChunkGradients& gradients, std::int32_t cell);

 private:
  static constexpr std::int32_t kNotSeen = -1, kNoSurface = -2;
  std::int32_t find(const ElasticState& state, const ContactPoints& points,
                    ChunkGradients& gradients, std::int32_t cell);

  std::vector<std::int32_t> index_;  // per cell of the box: index in sides_, kNotSeen or kNoSurface
  std::vector<std::int32_t> seen_;   // cells whose index_ is not kNotSeen
  std::vector<AreaBySide> sides_;
  std::vector<ContactPoint> found_;  // work space
};

}  // namespace resect
