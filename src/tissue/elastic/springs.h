// Springs on single cells: ligaments, and the grips of tools.
//
// Each is a damped spring from a cell to an anchor, which is fixed in the world or in a tool's
// coordinate frame. While a cell has springs, its load (ElasticState::load) is computed anew in
// each substep from these springs and its joints.
#pragma once

#include <span>
#include <vector>

#include "tissue/elastic/elastic_state.h"
#include "tissue/tissue_model.h"

namespace resect {

struct TissueSpring {
  std::int32_t cell = 0;       // index in the box
  std::int32_t tool = -1;      // the tool that grips the cell; -1: the anchor is in the world
  Vec3 anchor = Vec3::Zero();  // where the spring pulls to, in the tool's frame or the world, m
  double stiffness = 0;        // N/m
  double damping = 0;          // N s/m

  template <class Visitor>
  void visit(Visitor& v) {
    v("cell", cell), v("tool", tool), v("anchor", anchor);
    v("stiffness", stiffness), v("damping", damping);
  }
};

class TissueSprings {
 public:
  void add(const TissueSpring& spring) { springs_.push_back(spring); }
  // Removes the springs for which drop(spring) is true; returns their cells.
  template <typename Drop>
  std::vector<std::int32_t> drop(Drop drop) {
    std::vector<std::int32_t> cells;
    std::erase_if(springs_, [&](const TissueSpring& spring) {
      if (drop(spring)) cells.push_back(spring.cell);
      return drop(spring);
    });
    return cells;
  }
  std::span<const TissueSpring> all() const { return springs_; }

  // Adds the springs' forces to the loads, for a substep of `dt` s that ends at the fraction
  // `share` (0 to 1) of the frame. frame: the frame's duration, s. origin: rest position of cell
  // (0, 0, 0), m. Springs of tools that are not among the obstacles exert no force.
  void pull(ElasticState& state, const Vec3& origin, std::span<const Obstacle> obstacles,
            double share, double frame, double dt);
  // Momentum given to each of the obstacles since forgetImpulses(), kg m/s.
  std::span<const Vec3> impulse() const { return impulse_; }
  void forgetImpulses(std::size_t obstacles) { impulse_.assign(obstacles, Vec3::Zero()); }

  template <class Visitor>
  void visit(Visitor& v) {
    v("springs", springs_);
  }
  template <class Visitor>
  void visitMade(Visitor& v) {
    v.made(impulse_);
  }

 private:
  std::vector<TissueSpring> springs_;
  std::vector<Vec3> impulse_;  // per obstacle
};

}  // namespace resect
