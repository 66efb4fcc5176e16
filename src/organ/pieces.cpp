#include "organ/pieces.h"

#include <algorithm>
#include <numeric>

#include "collision/inside.h"
#include "geometry/measures.h"
#include "geometry/topology.h"

namespace resect {

std::vector<TriangleMesh> bodies(const TriangleMesh& surface) {
  std::vector<TriangleMesh> skins, cavities;
  for (TriangleMesh& piece : splitComponents(surface))
    (volume(piece) >= 0 ? skins : cavities).push_back(std::move(piece));

  std::vector<double> volumes;
  for (const TriangleMesh& skin : skins) volumes.push_back(volume(skin));
  std::vector<std::size_t> order(skins.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](auto a, auto b) { return volumes[a] > volumes[b]; });

  std::vector<TriangleMesh> result;
  for (const std::size_t i : order) result.push_back(skins[i]);
  for (const TriangleMesh& cavity : cavities) {
    // The smallest skin round a point of the cavity; the surface never touches itself, so one point
    // decides.
    for (std::size_t i = result.size(); i-- > 0;)
      if (insideFlags(skins[order[i]], std::span(cavity.points.data(), 1))[0]) {
        append(result[i], cavity);
        break;
      }
  }
  return result;
}

}  // namespace resect
