#include "surface/node_places.h"

#include "surface/brick_window.h"

namespace resect {

void bindNodes(const ColourField& field, const Wound& wound, float iso, const Vec3i& brick,
               const PlacedNodes& wanted, std::span<VertexBinding, kPlacedNodes> bindings) {
  const BrickWindow window(field, wound.severed, brick, iso);
  VertexBinder binder(window.grid, field.lattice(), field.refine(), wound.particles);
  for (int i = 0; i < kPlacedNodes; ++i) {
    if (!wanted[std::size_t(i)]) continue;
    const Vec3i n(i % 5, i / 5 % 5, i / 25), inWindow = n + Vec3i::Constant(BrickWindow::kHalo);
    const Vec3 p = inWindow.cast<double>();
    bindings[std::size_t(i)] = window.grid.inside(BrickWindow::index(n))
                                   ? binder.bind(p, inWindow, nearbyNode(0, 0, 0))
                                   : binder.bindAll(p);
  }
}

}  // namespace resect
