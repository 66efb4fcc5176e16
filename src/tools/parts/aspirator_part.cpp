#include "tools/parts/aspirator_part.h"

#include <algorithm>

#include "tools/tool.h"

namespace resect {
namespace {

constexpr double kAspiratorReach =
    0.0035;  // m: beyond which tissue is left alone, in a fine lattice
constexpr double kAspiratorReachCells = 0.6;  // of the spacing, in a coarse one
constexpr double kSpares = 0.5e-3;            // m: radius of vessels that stay
constexpr double kSucksWithin = 0.005;        // m
constexpr double kRate = 8e-6;                // m^3/s: of blood

}  // namespace

void AspiratorPart::act(const Touch& touch, std::vector<TissueEdit>& edits) const {
  const Vec3 tip = touch.way.to.pose * touch.model.tip,
             from = touch.way.from.pose * touch.model.tip;
  if (touch.organNumber == 0) edits.push_back(touch.edit(Suction{tip, kSucksWithin, kRate}));
  const Lattice& lattice = touch.organ.rest.lattice;
  const double reach = std::max(kAspiratorReach, kAspiratorReachCells * lattice.spacing.x());
  Aabb box;
  box.grow(tip);
  box.grow(from);
  const Vec3 way = tip - from;
  for (const std::int64_t cell : touch.tissue.cellsIn(box.padded(reach))) {
    const Vec3 place = lattice.centre(lattice.cell(cell)) + touch.tissue.displacement(cell);
    const double square = way.squaredNorm();
    const double share = square > 0 ? std::clamp((place - from).dot(way) / square, 0.0, 1.0) : 0;
    if ((from + share * way - place).norm() <= reach)
      edits.push_back(touch.edit(RemoveCell{cell, kSpares}));
  }
}

}  // namespace resect
