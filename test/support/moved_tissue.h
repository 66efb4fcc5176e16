// Tissue that instruments press: a frame of it, with what tears and slips done at once, as a
// simulation does it; a layer; shapes.
#pragma once

#include "geometry/primitives.h"
#include "support/tissue_blocks.h"
#include "tissue/move_tissues.h"

namespace resect::test {

inline Obstacle instrument(std::int32_t tool, const SignedDistance* shape, const Pose& from,
                           const Pose& to, double friction, double slipForce) {
  return {tool, shape, false, from, to, false, friction, slipForce};
}

inline void moveAndTear(TissueModel& tissue, double duration, std::span<const Obstacle> obstacles,
                        TissueStep& step) {
  moveTissue(tissue, obstacles, duration, step);
  for (const std::int32_t tool : step.letGo) tissue.release(tool);
  for (const TissueBond& bond : step.torn) tissue.sever(bond.cell, bond.direction);
  tissue.settle();
}

// A layer of about 64 x `thickness` x 64 mm without weight, held at its ground.
struct TissueLayer {
  double spacing;  // m
  TissueCells cells;
  ElasticTissue tissue;
  Vec3 top;     // middle of the upper face, m
  Vec3 centre;  // middle of a cell's upper face near there, m

  TissueLayer(double s, double thickness, double drag, const TissueMaterial& material)
      : spacing(s),
        cells(solidBlock(dimsOf(s, thickness), s, material)),
        tissue(cells, settings(drag)) {
    const Vec3i dims = cells.lattice.dims;
    top = s * (0.5 * (dims - Vec3i::Ones()).cast<double>());
    top.y() = s * (dims.y() - 0.5);
    centre = s * Vec3(dims.x() / 2, dims.y() - 0.5, dims.z() / 2);
    forEachCell(tissue, [&](std::int64_t c, const Vec3i& x) {
      if (x.y() == 0) tissue.hold(c, kHeldAll);
    });
  }
  static Vec3i dimsOf(double s, double thickness) {
    const auto cellsIn = [&](double side) { return int(side / s + 0.5); };
    return {cellsIn(0.064), cellsIn(thickness), cellsIn(0.064)};
  }
  static TissueSettings settings(double drag) {
    TissueSettings settings = weightless();
    settings.drag = drag;
    return settings;
  }
};

// Shapes to press into it; the lowest point of each is at the origin.
inline SignedDistance barOf(double side) {
  return {boxMesh({{-side / 2, 0, -side / 2}, {side / 2, 0.06, side / 2}}), 0.016, 0.0008};
}
inline SignedDistance ballOf(double radius) {
  return {sphereMesh(Vec3(0, radius, 0), radius, 128), 0.016, 0.0006};
}

}  // namespace resect::test
