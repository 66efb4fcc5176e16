// The shapes of what hangs on the built-in liver: the gallbladder in its fossa, and the stumps of
// the falciform and the round ligament, which the surgeon has divided to free the liver.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/pose.h"
#include "geometry/triangle_mesh.h"
#include "sph/discretization.h"

namespace resect {

// What a point of the shapes shows. The number is written into the mesh's cut share, together with
// a fraction from 0 to 0.9; data/shaders/strand.frag reads both.
// - Gallbladder: the fraction is 0 at the bed in the liver, 0.9 on the free side.
// - Ligament (falciform): the fraction is 0 at the liver, 0.9 at the cut edge.
// - Cord (round ligament): the fraction is 0 on the cord, 0.9 on the ligature.
enum class AdnexaLook { Gallbladder = 16, Ligament = 17, Cord = 18 };

struct LiverAdnexa {
  TriangleMesh mesh;                 // m, coordinates of the built-in liver
  std::vector<float> look;           // per point: an AdnexaLook plus a fraction
  std::vector<std::int32_t> anchor;  // per point: the anchor that it follows, an index
  // Places in the liver's tissue, m: the points of the mesh that have this anchor move with the
  // tissue there. The anchors of the falciform ligament come first, from the liver's lower margin
  // to its dome; then comes the anchor of the gallbladder.
  std::vector<Vec3> anchors;
};

LiverAdnexa liverAdnexa();

// The pose in which the organ is the built-in liver; none if it is another organ. The pose is found
// from the axes of inertia of the particles, with an error of about a millimetre. For it to count,
// 97 % of the particles have to lie inside the liver's shape, and the volumes have to agree within
// 4 %. Cost: some 20 ms.
std::optional<Pose> builtinLiverPose(const Discretization& organ);

}  // namespace resect
