#include "io/drawn_parts.h"

#include <algorithm>
#include <utility>

#include "base/error.h"
#include "base/text/shown_text.h"
#include "geometry/measures.h"
#include "geometry/rotation.h"
#include "geometry/topology.h"
#include "io/organ_mesh.h"

namespace resect {
namespace {

// By what angle a part is turned about the jaws' axis when they are wide open, rad.
double opening(const ModelPart& part, const Jaws& jaws, const std::string& path) {
  if (!(jaws.opening > 0) || !part.name.starts_with("Jaw")) return 0;
  if (part.name.starts_with("JawUpper")) return 0.5 * jaws.opening;
  if (part.name.starts_with("JawLower")) return -0.5 * jaws.opening;
  throw error(
      "{}: the part '{}' is neither jaw; begin the names of its two jaws with JawUpper and "
      "JawLower",
      path, shownText(part.name, kLongestName));
}

void close(DrawnPart& part, const Jaws& jaws) {
  const Eigen::Quaterniond turn = rotationAbout(jaws.axis, -part.opens);
  for (Vec3& p : part.mesh.points) p = jaws.pivot + turn * (p - jaws.pivot);
  for (Vec3f& n : part.normals) n = turn.cast<float>() * n;
}

}  // namespace

std::vector<DrawnPart> drawnParts(const Model& model, const Jaws& jaws) {
  std::vector<DrawnPart> drawn;
  for (const ModelPart& part : model.parts) {
    WeldedSurface welded = weldSurface(part.mesh);
    if (welded.mesh.triangles.empty()) continue;
    const bool closed = welded.topology.closed() && welded.topology.oriented();
    const bool insideOut = closed && volume(welded.mesh) < 0;
    const bool hasNormals =
        !part.normals.empty() &&
        std::ranges::none_of(part.normals, [](const Vec3f& n) { return n.isZero(0); });
    DrawnPart one{hasNormals ? part.mesh : std::move(welded.mesh),
                  hasNormals ? part.normals : std::vector<Vec3f>(), part.finish, closed,
                  opening(part, jaws, model.path)};
    if (insideOut) flip(one.mesh);
    if (one.opens != 0) close(one, jaws);
    drawn.push_back(std::move(one));
  }
  return drawn;
}

}  // namespace resect
