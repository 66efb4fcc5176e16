#include "wound/node_places.h"

#include <optional>

#include "wound/brick_window.h"

namespace resect {
namespace {

// A search beyond a node's cube stays in the window of the node's brick, so it does not depend on
// the other nodes.
struct FarSearch {
  Vec3i brick;
  BrickWindow window;
  VertexBinder binder;

  FarSearch(const ColourField& field, const Wound& wound, const Vec3i& at, float iso)
      : brick(at),
        window(field, wound.severed, at, iso),
        binder(window.grid, field.lattice(), field.refine(), wound.particles) {}
};

}  // namespace

std::vector<VertexBinding> bindNodes(const ColourField& field, const Wound& wound, float iso,
                                     std::span<const Vec3i> nodes) {
  std::vector<VertexBinding> bindings;
  if (nodes.empty()) return bindings;
  bindings.reserve(nodes.size());
  const int refine = field.refine();
  const IndexBox box = boxRound(nodes).widened(refine);  // the lattice cubes that contain them
  const BoxWindow window(field, wound.severed, box, iso);
  VertexBinder binder(window.grid, field.lattice(), refine, wound.particles);
  std::optional<FarSearch> far;
  constexpr NearbyNodes kItself = nearbyNode(0, 0, 0);
  for (const Vec3i& n : nodes) {
    const Vec3i inWindow = n - box.low;
    const Vec3 p = inWindow.cast<double>();
    if (!window.grid.inside(window.grid.index(inWindow))) {
      bindings.push_back(binder.bindAll(p));
      continue;
    }
    bindings.push_back(binder.bindWithin(p, inWindow, kItself));
    if (bindings.back().count > 0) continue;
    const Vec3i brick = n / kBrickNodes;
    if (!far || far->brick != brick) far.emplace(field, wound, brick, iso);
    const Vec3i inBrick = n - far->window.grid.first;
    bindings.back() = far->binder.bind(inBrick.cast<double>(), inBrick, kItself);
  }
  return bindings;
}

}  // namespace resect
