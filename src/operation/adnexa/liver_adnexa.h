// The shapes of what hangs on the built-in liver: the gallbladder in its fossa, and the stumps of
// the falciform and the round ligament, which the surgeon has divided to free the liver.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "anatomy/anatomy.h"
#include "geometry/triangle_mesh.h"

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

// The pose of the built-in liver whose vessels these are; none if they are other vessels.
std::optional<Pose> builtinLiverPose(const Anatomy& vessels);

}  // namespace resect
